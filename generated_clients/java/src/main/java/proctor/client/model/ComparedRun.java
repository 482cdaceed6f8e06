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

/** One run beside the baseline. A pair is an episode that both have scored. */
public class ComparedRun {
  @SerializedName("run_id")
  @javax.annotation.Nonnull
  private String runId;

  @SerializedName("complete")
  @javax.annotation.Nonnull
  private Boolean complete;

  @SerializedName("release")
  @javax.annotation.Nonnull
  private Boolean release;

  @SerializedName("paired")
  @javax.annotation.Nonnull
  private Integer paired;

  @SerializedName("baseline_mean")
  private Double baselineMean;

  @SerializedName("mean")
  private Double mean;

  @SerializedName("difference")
  private Double difference;

  @SerializedName("wins")
  @javax.annotation.Nonnull
  private Integer wins;

  @SerializedName("losses")
  @javax.annotation.Nonnull
  private Integer losses;

  @SerializedName("ties")
  @javax.annotation.Nonnull
  private Integer ties;

  @SerializedName("p_value")
  @javax.annotation.Nonnull
  private Double pValue;

  @SerializedName("by_task")
  @javax.annotation.Nonnull
  private Map<String, ComparedTask> byTask;

  public String getRunId() {
    return runId;
  }

  public ComparedRun runId(String runId) {
    this.runId = runId;
    return this;
  }

  public void setRunId(String runId) {
    this.runId = runId;
  }

  /** Both runs have scored every episode. */
  public Boolean getComplete() {
    return complete;
  }

  public ComparedRun complete(Boolean complete) {
    this.complete = complete;
    return this;
  }

  public void setComplete(Boolean complete) {
    this.complete = complete;
  }

  /** Complete, and no difference, over all episodes or over those of a task, is beyond the tolerance. */
  public Boolean getRelease() {
    return release;
  }

  public ComparedRun release(Boolean release) {
    this.release = release;
    return this;
  }

  public void setRelease(Boolean release) {
    this.release = release;
  }

  /** Number of pairs. */
  public Integer getPaired() {
    return paired;
  }

  public ComparedRun paired(Integer paired) {
    this.paired = paired;
    return this;
  }

  public void setPaired(Integer paired) {
    this.paired = paired;
  }

  /** Mean score of the baseline over the pairs. */
  public Double getBaselineMean() {
    return baselineMean;
  }

  public ComparedRun baselineMean(Double baselineMean) {
    this.baselineMean = baselineMean;
    return this;
  }

  public void setBaselineMean(Double baselineMean) {
    this.baselineMean = baselineMean;
  }

  /** Mean score of the run over the pairs. */
  public Double getMean() {
    return mean;
  }

  public ComparedRun mean(Double mean) {
    this.mean = mean;
    return this;
  }

  public void setMean(Double mean) {
    this.mean = mean;
  }

  /** Baseline minus run: positive when the run is worse. */
  public Double getDifference() {
    return difference;
  }

  public ComparedRun difference(Double difference) {
    this.difference = difference;
    return this;
  }

  public void setDifference(Double difference) {
    this.difference = difference;
  }

  /** Pairs in which the run alone succeeds. */
  public Integer getWins() {
    return wins;
  }

  public ComparedRun wins(Integer wins) {
    this.wins = wins;
    return this;
  }

  public void setWins(Integer wins) {
    this.wins = wins;
  }

  /** Pairs in which the baseline alone succeeds. */
  public Integer getLosses() {
    return losses;
  }

  public ComparedRun losses(Integer losses) {
    this.losses = losses;
    return this;
  }

  public void setLosses(Integer losses) {
    this.losses = losses;
  }

  /** Pairs in which both succeed or neither does. */
  public Integer getTies() {
    return ties;
  }

  public ComparedRun ties(Integer ties) {
    this.ties = ties;
    return this;
  }

  public void setTies(Integer ties) {
    this.ties = ties;
  }

  /** McNemar&#39;s exact test, two-sided. */
  public Double getpValue() {
    return pValue;
  }

  public ComparedRun pValue(Double pValue) {
    this.pValue = pValue;
    return this;
  }

  public void setpValue(Double pValue) {
    this.pValue = pValue;
  }

  /** Task → the pairs of its episodes. */
  public Map<String, ComparedTask> getByTask() {
    return byTask;
  }

  public ComparedRun byTask(Map<String, ComparedTask> byTask) {
    this.byTask = byTask;
    return this;
  }

  public void setByTask(Map<String, ComparedTask> byTask) {
    this.byTask = byTask;
  }

  public static ComparedRun fromJson(String text) {
    return JSON.getGson().fromJson(text, ComparedRun.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
