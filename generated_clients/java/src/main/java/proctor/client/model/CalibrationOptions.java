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

/** Only for the benchmark &#x60;calibration&#x60;, which the submitter shapes. */
public class CalibrationOptions {
  @SerializedName("tasks")
  private List<CalibrationTask> tasks;

  @SerializedName("max_steps")
  private Integer maxSteps;

  @SerializedName("success_rule")
  private SuccessRule successRule;

  @SerializedName("max_attempts")
  private Integer maxAttempts;

  @SerializedName("max_faults")
  private Integer maxFaults;

  @SerializedName("sealed")
  private Boolean sealed;

  @SerializedName("queue_s")
  private Double queueS;

  /** One entry per episode, in order; one &#x60;score&#x60; episode when absent. */
  public List<CalibrationTask> getTasks() {
    return tasks;
  }

  public CalibrationOptions tasks(List<CalibrationTask> tasks) {
    this.tasks = tasks;
    return this;
  }

  public void setTasks(List<CalibrationTask> tasks) {
    this.tasks = tasks;
  }

  /** 10 when absent. */
  public Integer getMaxSteps() {
    return maxSteps;
  }

  public CalibrationOptions maxSteps(Integer maxSteps) {
    this.maxSteps = maxSteps;
    return this;
  }

  public void setMaxSteps(Integer maxSteps) {
    this.maxSteps = maxSteps;
  }

  public SuccessRule getSuccessRule() {
    return successRule;
  }

  public CalibrationOptions successRule(SuccessRule successRule) {
    this.successRule = successRule;
    return this;
  }

  public void setSuccessRule(SuccessRule successRule) {
    this.successRule = successRule;
  }

  /** 3 when absent. */
  public Integer getMaxAttempts() {
    return maxAttempts;
  }

  public CalibrationOptions maxAttempts(Integer maxAttempts) {
    this.maxAttempts = maxAttempts;
    return this;
  }

  public void setMaxAttempts(Integer maxAttempts) {
    this.maxAttempts = maxAttempts;
  }

  /** 3 when absent. */
  public Integer getMaxFaults() {
    return maxFaults;
  }

  public CalibrationOptions maxFaults(Integer maxFaults) {
    this.maxFaults = maxFaults;
    return this;
  }

  public void setMaxFaults(Integer maxFaults) {
    this.maxFaults = maxFaults;
  }

  /** Whether the seeds of the split &#x60;odd&#x60; are sealed; false when absent. Only for servers that announce the profile &#x60;sealed_seeds&#x60;. */
  public Boolean getSealed() {
    return sealed;
  }

  public CalibrationOptions sealed(Boolean sealed) {
    this.sealed = sealed;
    return this;
  }

  public void setSealed(Boolean sealed) {
    this.sealed = sealed;
  }

  /** Seconds for which the run stays queued after submit and after resume; 0 when absent. */
  public Double getQueueS() {
    return queueS;
  }

  public CalibrationOptions queueS(Double queueS) {
    this.queueS = queueS;
    return this;
  }

  public void setQueueS(Double queueS) {
    this.queueS = queueS;
  }

  public static CalibrationOptions fromJson(String text) {
    return JSON.getGson().fromJson(text, CalibrationOptions.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
