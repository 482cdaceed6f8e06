/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


package proctor.client.model;

import com.google.gson.annotations.SerializedName;
import java.time.OffsetDateTime;
import java.util.List;
import java.util.Map;
import java.util.Set;
import proctor.client.JSON;

/** Of the &#x60;get_score&#x60; of the run. */
public class EntryScore {
  @SerializedName("score")
  @javax.annotation.Nonnull
  private Double score;

  @SerializedName("success_rate")
  @javax.annotation.Nonnull
  private Double successRate;

  @SerializedName("success_interval")
  @javax.annotation.Nonnull
  private Interval successInterval;

  @SerializedName("mean_interval")
  @javax.annotation.Nonnull
  private Interval meanInterval;

  @SerializedName("counts")
  @javax.annotation.Nonnull
  private OutcomeCounts counts;

  @SerializedName("by_task")
  private Map<String, GroupScore> byTask;

  @SerializedName("by_split")
  private Map<String, GroupScore> bySplit;

  public Double getScore() {
    return score;
  }

  public EntryScore score(Double score) {
    this.score = score;
    return this;
  }

  public void setScore(Double score) {
    this.score = score;
  }

  public Double getSuccessRate() {
    return successRate;
  }

  public EntryScore successRate(Double successRate) {
    this.successRate = successRate;
    return this;
  }

  public void setSuccessRate(Double successRate) {
    this.successRate = successRate;
  }

  public Interval getSuccessInterval() {
    return successInterval;
  }

  public EntryScore successInterval(Interval successInterval) {
    this.successInterval = successInterval;
    return this;
  }

  public void setSuccessInterval(Interval successInterval) {
    this.successInterval = successInterval;
  }

  public Interval getMeanInterval() {
    return meanInterval;
  }

  public EntryScore meanInterval(Interval meanInterval) {
    this.meanInterval = meanInterval;
    return this;
  }

  public void setMeanInterval(Interval meanInterval) {
    this.meanInterval = meanInterval;
  }

  public OutcomeCounts getCounts() {
    return counts;
  }

  public EntryScore counts(OutcomeCounts counts) {
    this.counts = counts;
    return this;
  }

  public void setCounts(OutcomeCounts counts) {
    this.counts = counts;
  }

  /** Absent where the server does not show it, such as for many tasks. */
  public Map<String, GroupScore> getByTask() {
    return byTask;
  }

  public EntryScore byTask(Map<String, GroupScore> byTask) {
    this.byTask = byTask;
    return this;
  }

  public void setByTask(Map<String, GroupScore> byTask) {
    this.byTask = byTask;
  }

  /** Absent where the server does not show it, such as for many splits. */
  public Map<String, GroupScore> getBySplit() {
    return bySplit;
  }

  public EntryScore bySplit(Map<String, GroupScore> bySplit) {
    this.bySplit = bySplit;
    return this;
  }

  public void setBySplit(Map<String, GroupScore> bySplit) {
    this.bySplit = bySplit;
  }

  public static EntryScore fromJson(String text) {
    return JSON.getGson().fromJson(text, EntryScore.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
