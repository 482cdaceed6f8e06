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

/** See scoring.md for every number here. */
public class Score {
  @SerializedName("run_id")
  @javax.annotation.Nonnull
  private String runId;

  @SerializedName("benchmark_id")
  @javax.annotation.Nonnull
  private String benchmarkId;

  @SerializedName("manifest_sha256")
  @javax.annotation.Nonnull
  private String manifestSha256;

  @SerializedName("select")
  private SelectionView select;

  @SerializedName("state")
  @javax.annotation.Nonnull
  private RunState state;

  @SerializedName("complete")
  @javax.annotation.Nonnull
  private Boolean complete;

  @SerializedName("score")
  private Double score;

  @SerializedName("score_low")
  @javax.annotation.Nonnull
  private Double scoreLow;

  @SerializedName("score_high")
  @javax.annotation.Nonnull
  private Double scoreHigh;

  @SerializedName("counts")
  @javax.annotation.Nonnull
  private OutcomeCounts counts;

  @SerializedName("success_rate")
  private Double successRate;

  @SerializedName("success_interval")
  @javax.annotation.Nonnull
  private Interval successInterval;

  @SerializedName("mean")
  private Double mean;

  @SerializedName("mean_interval")
  @javax.annotation.Nonnull
  private Interval meanInterval;

  @SerializedName("by_task")
  @javax.annotation.Nonnull
  private Map<String, GroupScore> byTask;

  @SerializedName("by_split")
  @javax.annotation.Nonnull
  private Map<String, GroupScore> bySplit;

  public String getRunId() {
    return runId;
  }

  public Score runId(String runId) {
    this.runId = runId;
    return this;
  }

  public void setRunId(String runId) {
    this.runId = runId;
  }

  public String getBenchmarkId() {
    return benchmarkId;
  }

  public Score benchmarkId(String benchmarkId) {
    this.benchmarkId = benchmarkId;
    return this;
  }

  public void setBenchmarkId(String benchmarkId) {
    this.benchmarkId = benchmarkId;
  }

  /** The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software. */
  public String getManifestSha256() {
    return manifestSha256;
  }

  public Score manifestSha256(String manifestSha256) {
    this.manifestSha256 = manifestSha256;
    return this;
  }

  public void setManifestSha256(String manifestSha256) {
    this.manifestSha256 = manifestSha256;
  }

  public SelectionView getSelect() {
    return select;
  }

  public Score select(SelectionView select) {
    this.select = select;
    return this;
  }

  public void setSelect(SelectionView select) {
    this.select = select;
  }

  public RunState getState() {
    return state;
  }

  public Score state(RunState state) {
    this.state = state;
    return this;
  }

  public void setState(RunState state) {
    this.state = state;
  }

  public Boolean getComplete() {
    return complete;
  }

  public Score complete(Boolean complete) {
    this.complete = complete;
    return this;
  }

  public void setComplete(Boolean complete) {
    this.complete = complete;
  }

  /** Null until complete. */
  public Double getScore() {
    return score;
  }

  public Score score(Double score) {
    this.score = score;
    return this;
  }

  public void setScore(Double score) {
    this.score = score;
  }

  public Double getScoreLow() {
    return scoreLow;
  }

  public Score scoreLow(Double scoreLow) {
    this.scoreLow = scoreLow;
    return this;
  }

  public void setScoreLow(Double scoreLow) {
    this.scoreLow = scoreLow;
  }

  public Double getScoreHigh() {
    return scoreHigh;
  }

  public Score scoreHigh(Double scoreHigh) {
    this.scoreHigh = scoreHigh;
    return this;
  }

  public void setScoreHigh(Double scoreHigh) {
    this.scoreHigh = scoreHigh;
  }

  public OutcomeCounts getCounts() {
    return counts;
  }

  public Score counts(OutcomeCounts counts) {
    this.counts = counts;
    return this;
  }

  public void setCounts(OutcomeCounts counts) {
    this.counts = counts;
  }

  public Double getSuccessRate() {
    return successRate;
  }

  public Score successRate(Double successRate) {
    this.successRate = successRate;
    return this;
  }

  public void setSuccessRate(Double successRate) {
    this.successRate = successRate;
  }

  public Interval getSuccessInterval() {
    return successInterval;
  }

  public Score successInterval(Interval successInterval) {
    this.successInterval = successInterval;
    return this;
  }

  public void setSuccessInterval(Interval successInterval) {
    this.successInterval = successInterval;
  }

  /** Mean over the scored episodes. */
  public Double getMean() {
    return mean;
  }

  public Score mean(Double mean) {
    this.mean = mean;
    return this;
  }

  public void setMean(Double mean) {
    this.mean = mean;
  }

  public Interval getMeanInterval() {
    return meanInterval;
  }

  public Score meanInterval(Interval meanInterval) {
    this.meanInterval = meanInterval;
    return this;
  }

  public void setMeanInterval(Interval meanInterval) {
    this.meanInterval = meanInterval;
  }

  public Map<String, GroupScore> getByTask() {
    return byTask;
  }

  public Score byTask(Map<String, GroupScore> byTask) {
    this.byTask = byTask;
    return this;
  }

  public void setByTask(Map<String, GroupScore> byTask) {
    this.byTask = byTask;
  }

  public Map<String, GroupScore> getBySplit() {
    return bySplit;
  }

  public Score bySplit(Map<String, GroupScore> bySplit) {
    this.bySplit = bySplit;
    return this;
  }

  public void setBySplit(Map<String, GroupScore> bySplit) {
    this.bySplit = bySplit;
  }

  public static Score fromJson(String text) {
    return JSON.getGson().fromJson(text, Score.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
