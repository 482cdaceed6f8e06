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

public class SubmitRun {
  @SerializedName("benchmark_id")
  @javax.annotation.Nonnull
  private String benchmarkId;

  @SerializedName("policy")
  @javax.annotation.Nonnull
  private PolicyInfo policy;

  @SerializedName("max_workers")
  private Integer maxWorkers;

  @SerializedName("idle_timeout_s")
  private Double idleTimeoutS;

  @SerializedName("images")
  private ImageChoice images;

  @SerializedName("options")
  private CalibrationOptions options;

  @SerializedName("mode")
  private RunMode mode;

  @SerializedName("policy_server")
  private PolicyServer policyServer;

  @SerializedName("any_policy")
  private Boolean anyPolicy;

  @SerializedName("select")
  private EpisodeSelection select;

  public String getBenchmarkId() {
    return benchmarkId;
  }

  public SubmitRun benchmarkId(String benchmarkId) {
    this.benchmarkId = benchmarkId;
    return this;
  }

  public void setBenchmarkId(String benchmarkId) {
    this.benchmarkId = benchmarkId;
  }

  public PolicyInfo getPolicy() {
    return policy;
  }

  public SubmitRun policy(PolicyInfo policy) {
    this.policy = policy;
    return this;
  }

  public void setPolicy(PolicyInfo policy) {
    this.policy = policy;
  }

  /** Most live workers wanted; the server&#39;s limit when absent. */
  public Integer getMaxWorkers() {
    return maxWorkers;
  }

  public SubmitRun maxWorkers(Integer maxWorkers) {
    this.maxWorkers = maxWorkers;
    return this;
  }

  public void setMaxWorkers(Integer maxWorkers) {
    this.maxWorkers = maxWorkers;
  }

  /** Lease of a session; the server&#39;s maximum when absent. */
  public Double getIdleTimeoutS() {
    return idleTimeoutS;
  }

  public SubmitRun idleTimeoutS(Double idleTimeoutS) {
    this.idleTimeoutS = idleTimeoutS;
    return this;
  }

  public void setIdleTimeoutS(Double idleTimeoutS) {
    this.idleTimeoutS = idleTimeoutS;
  }

  public ImageChoice getImages() {
    return images;
  }

  public SubmitRun images(ImageChoice images) {
    this.images = images;
    return this;
  }

  public void setImages(ImageChoice images) {
    this.images = images;
  }

  public CalibrationOptions getOptions() {
    return options;
  }

  public SubmitRun options(CalibrationOptions options) {
    this.options = options;
    return this;
  }

  public void setOptions(CalibrationOptions options) {
    this.options = options;
  }

  public RunMode getMode() {
    return mode;
  }

  public SubmitRun mode(RunMode mode) {
    this.mode = mode;
    return this;
  }

  public void setMode(RunMode mode) {
    this.mode = mode;
  }

  public PolicyServer getPolicyServer() {
    return policyServer;
  }

  public SubmitRun policyServer(PolicyServer policyServer) {
    this.policyServer = policyServer;
    return this;
  }

  public void setPolicyServer(PolicyServer policyServer) {
    this.policyServer = policyServer;
  }

  /** Workers may play for another policy than &#x60;policy&#x60;; false when absent; for the profile &#x60;attribution&#x60;. */
  public Boolean getAnyPolicy() {
    return anyPolicy;
  }

  public SubmitRun anyPolicy(Boolean anyPolicy) {
    this.anyPolicy = anyPolicy;
    return this;
  }

  public void setAnyPolicy(Boolean anyPolicy) {
    this.anyPolicy = anyPolicy;
  }

  public EpisodeSelection getSelect() {
    return select;
  }

  public SubmitRun select(EpisodeSelection select) {
    this.select = select;
    return this;
  }

  public void setSelect(EpisodeSelection select) {
    this.select = select;
  }

  public static SubmitRun fromJson(String text) {
    return JSON.getGson().fromJson(text, SubmitRun.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
