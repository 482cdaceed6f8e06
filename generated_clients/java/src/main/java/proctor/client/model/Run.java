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

public class Run {
  @SerializedName("run_id")
  @javax.annotation.Nonnull
  private String runId;

  @SerializedName("state")
  @javax.annotation.Nonnull
  private RunState state;

  @SerializedName("reason")
  private String reason;

  @SerializedName("retryable")
  private Boolean retryable;

  @SerializedName("benchmark_id")
  @javax.annotation.Nonnull
  private String benchmarkId;

  @SerializedName("benchmark_version")
  @javax.annotation.Nonnull
  private String benchmarkVersion;

  @SerializedName("manifest_sha256")
  @javax.annotation.Nonnull
  private String manifestSha256;

  @SerializedName("policy")
  @javax.annotation.Nonnull
  private PolicyInfo policy;

  @SerializedName("mode")
  private String mode;

  @SerializedName("policy_server")
  private PolicyServerView policyServer;

  @SerializedName("any_policy")
  private Boolean anyPolicy;

  @SerializedName("select")
  private SelectionView select;

  @SerializedName("max_workers")
  @javax.annotation.Nonnull
  private Integer maxWorkers;

  @SerializedName("idle_timeout_s")
  @javax.annotation.Nonnull
  private Double idleTimeoutS;

  @SerializedName("images")
  @javax.annotation.Nonnull
  private ImageChoice images;

  @SerializedName("endpoint")
  @javax.annotation.Nonnull
  private String endpoint;

  @SerializedName("queue_position")
  private Integer queuePosition;

  @SerializedName("live_workers")
  @javax.annotation.Nonnull
  private Integer liveWorkers;

  @SerializedName("progress")
  @javax.annotation.Nonnull
  private Progress progress;

  @SerializedName("created_at")
  @javax.annotation.Nonnull
  private OffsetDateTime createdAt;

  @SerializedName("updated_at")
  @javax.annotation.Nonnull
  private OffsetDateTime updatedAt;

  @SerializedName("runs_played_before")
  private Integer runsPlayedBefore;

  @SerializedName("attempts_by_submitter")
  private Integer attemptsBySubmitter;

  public String getRunId() {
    return runId;
  }

  public Run runId(String runId) {
    this.runId = runId;
    return this;
  }

  public void setRunId(String runId) {
    this.runId = runId;
  }

  public RunState getState() {
    return state;
  }

  public Run state(RunState state) {
    this.state = state;
    return this;
  }

  public void setState(RunState state) {
    this.state = state;
  }

  /** Why the run is in this state, for people; never null when failed. */
  public String getReason() {
    return reason;
  }

  public Run reason(String reason) {
    this.reason = reason;
    return this;
  }

  public void setReason(String reason) {
    this.reason = reason;
  }

  /** Whether a failed run may be resumed; null in other states. */
  public Boolean getRetryable() {
    return retryable;
  }

  public Run retryable(Boolean retryable) {
    this.retryable = retryable;
    return this;
  }

  public void setRetryable(Boolean retryable) {
    this.retryable = retryable;
  }

  public String getBenchmarkId() {
    return benchmarkId;
  }

  public Run benchmarkId(String benchmarkId) {
    this.benchmarkId = benchmarkId;
    return this;
  }

  public void setBenchmarkId(String benchmarkId) {
    this.benchmarkId = benchmarkId;
  }

  public String getBenchmarkVersion() {
    return benchmarkVersion;
  }

  public Run benchmarkVersion(String benchmarkVersion) {
    this.benchmarkVersion = benchmarkVersion;
    return this;
  }

  public void setBenchmarkVersion(String benchmarkVersion) {
    this.benchmarkVersion = benchmarkVersion;
  }

  /** The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software. */
  public String getManifestSha256() {
    return manifestSha256;
  }

  public Run manifestSha256(String manifestSha256) {
    this.manifestSha256 = manifestSha256;
    return this;
  }

  public void setManifestSha256(String manifestSha256) {
    this.manifestSha256 = manifestSha256;
  }

  public PolicyInfo getPolicy() {
    return policy;
  }

  public Run policy(PolicyInfo policy) {
    this.policy = policy;
    return this;
  }

  public void setPolicy(PolicyInfo policy) {
    this.policy = policy;
  }

  /** A &#x60;RunMode&#x60;, or one of a later version; &#x60;pull&#x60; when absent. */
  public String getMode() {
    return mode;
  }

  public Run mode(String mode) {
    this.mode = mode;
    return this;
  }

  public void setMode(String mode) {
    this.mode = mode;
  }

  public PolicyServerView getPolicyServer() {
    return policyServer;
  }

  public Run policyServer(PolicyServerView policyServer) {
    this.policyServer = policyServer;
    return this;
  }

  public void setPolicyServer(PolicyServerView policyServer) {
    this.policyServer = policyServer;
  }

  /** Whether workers may play for another policy than &#x60;policy&#x60;; for the profile &#x60;attribution&#x60;. */
  public Boolean getAnyPolicy() {
    return anyPolicy;
  }

  public Run anyPolicy(Boolean anyPolicy) {
    this.anyPolicy = anyPolicy;
    return this;
  }

  public void setAnyPolicy(Boolean anyPolicy) {
    this.anyPolicy = anyPolicy;
  }

  public SelectionView getSelect() {
    return select;
  }

  public Run select(SelectionView select) {
    this.select = select;
    return this;
  }

  public void setSelect(SelectionView select) {
    this.select = select;
  }

  public Integer getMaxWorkers() {
    return maxWorkers;
  }

  public Run maxWorkers(Integer maxWorkers) {
    this.maxWorkers = maxWorkers;
    return this;
  }

  public void setMaxWorkers(Integer maxWorkers) {
    this.maxWorkers = maxWorkers;
  }

  public Double getIdleTimeoutS() {
    return idleTimeoutS;
  }

  public Run idleTimeoutS(Double idleTimeoutS) {
    this.idleTimeoutS = idleTimeoutS;
    return this;
  }

  public void setIdleTimeoutS(Double idleTimeoutS) {
    this.idleTimeoutS = idleTimeoutS;
  }

  public ImageChoice getImages() {
    return images;
  }

  public Run images(ImageChoice images) {
    this.images = images;
    return this;
  }

  public void setImages(ImageChoice images) {
    this.images = images;
  }

  /** Base URL of the data plane for this run; the path of an operation is appended to it. */
  public String getEndpoint() {
    return endpoint;
  }

  public Run endpoint(String endpoint) {
    this.endpoint = endpoint;
    return this;
  }

  public void setEndpoint(String endpoint) {
    this.endpoint = endpoint;
  }

  /** 1 is next; null unless queued. */
  public Integer getQueuePosition() {
    return queuePosition;
  }

  public Run queuePosition(Integer queuePosition) {
    this.queuePosition = queuePosition;
    return this;
  }

  public void setQueuePosition(Integer queuePosition) {
    this.queuePosition = queuePosition;
  }

  public Integer getLiveWorkers() {
    return liveWorkers;
  }

  public Run liveWorkers(Integer liveWorkers) {
    this.liveWorkers = liveWorkers;
    return this;
  }

  public void setLiveWorkers(Integer liveWorkers) {
    this.liveWorkers = liveWorkers;
  }

  public Progress getProgress() {
    return progress;
  }

  public Run progress(Progress progress) {
    this.progress = progress;
    return this;
  }

  public void setProgress(Progress progress) {
    this.progress = progress;
  }

  public OffsetDateTime getCreatedAt() {
    return createdAt;
  }

  public Run createdAt(OffsetDateTime createdAt) {
    this.createdAt = createdAt;
    return this;
  }

  public void setCreatedAt(OffsetDateTime createdAt) {
    this.createdAt = createdAt;
  }

  public OffsetDateTime getUpdatedAt() {
    return updatedAt;
  }

  public Run updatedAt(OffsetDateTime updatedAt) {
    this.updatedAt = updatedAt;
    return this;
  }

  public void setUpdatedAt(OffsetDateTime updatedAt) {
    this.updatedAt = updatedAt;
  }

  /** In how many runs of this benchmark its submitter had executed an action before the first one of this run, whether they were deleted or not; absent before that action. For the profile &#x60;deletion&#x60;. */
  public Integer getRunsPlayedBefore() {
    return runsPlayedBefore;
  }

  public Run runsPlayedBefore(Integer runsPlayedBefore) {
    this.runsPlayedBefore = runsPlayedBefore;
    return this;
  }

  public void setRunsPlayedBefore(Integer runsPlayedBefore) {
    this.runsPlayedBefore = runsPlayedBefore;
  }

  /** How many runs of this benchmark its submitter had submitted, this one included; for the profile &#x60;record&#x60;. */
  public Integer getAttemptsBySubmitter() {
    return attemptsBySubmitter;
  }

  public Run attemptsBySubmitter(Integer attemptsBySubmitter) {
    this.attemptsBySubmitter = attemptsBySubmitter;
    return this;
  }

  public void setAttemptsBySubmitter(Integer attemptsBySubmitter) {
    this.attemptsBySubmitter = attemptsBySubmitter;
  }

  public static Run fromJson(String text) {
    return JSON.getGson().fromJson(text, Run.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
