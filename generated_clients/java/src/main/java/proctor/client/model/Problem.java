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

/** RFC 9457, with what a client needs to decide on a retry. */
public class Problem {
  @SerializedName("type")
  @javax.annotation.Nonnull
  private String type;

  @SerializedName("title")
  @javax.annotation.Nonnull
  private String title;

  @SerializedName("status")
  @javax.annotation.Nonnull
  private Integer status;

  @SerializedName("detail")
  @javax.annotation.Nonnull
  private String detail;

  @SerializedName("code")
  @javax.annotation.Nonnull
  private String code;

  @SerializedName("retryable")
  @javax.annotation.Nonnull
  private Boolean retryable;

  @SerializedName("side_effects")
  @javax.annotation.Nonnull
  private SideEffects sideEffects;

  @SerializedName("errors")
  private List<ProblemItem> errors;

  @SerializedName("requirement")
  private String requirement;

  @SerializedName("state")
  private RunState state;

  @SerializedName("expected_seq")
  private Long expectedSeq;

  @SerializedName("ended_by")
  private String endedBy;

  public String getType() {
    return type;
  }

  public Problem type(String type) {
    this.type = type;
    return this;
  }

  public void setType(String type) {
    this.type = type;
  }

  public String getTitle() {
    return title;
  }

  public Problem title(String title) {
    this.title = title;
    return this;
  }

  public void setTitle(String title) {
    this.title = title;
  }

  public Integer getStatus() {
    return status;
  }

  public Problem status(Integer status) {
    this.status = status;
    return this;
  }

  public void setStatus(Integer status) {
    this.status = status;
  }

  /** What happened and what to do about it. */
  public String getDetail() {
    return detail;
  }

  public Problem detail(String detail) {
    this.detail = detail;
    return this;
  }

  public void setDetail(String detail) {
    this.detail = detail;
  }

  /** One of x-problems, or one of a later version. */
  public String getCode() {
    return code;
  }

  public Problem code(String code) {
    this.code = code;
    return this;
  }

  public void setCode(String code) {
    this.code = code;
  }

  /** Whether the same request can succeed later. */
  public Boolean getRetryable() {
    return retryable;
  }

  public Problem retryable(Boolean retryable) {
    this.retryable = retryable;
    return this;
  }

  public void setRetryable(Boolean retryable) {
    this.retryable = retryable;
  }

  public SideEffects getSideEffects() {
    return sideEffects;
  }

  public Problem sideEffects(SideEffects sideEffects) {
    this.sideEffects = sideEffects;
    return this;
  }

  public void setSideEffects(SideEffects sideEffects) {
    this.sideEffects = sideEffects;
  }

  public List<ProblemItem> getErrors() {
    return errors;
  }

  public Problem errors(List<ProblemItem> errors) {
    this.errors = errors;
    return this;
  }

  public void setErrors(List<ProblemItem> errors) {
    this.errors = errors;
  }

  /** Id of the rule that was enforced. */
  public String getRequirement() {
    return requirement;
  }

  public Problem requirement(String requirement) {
    this.requirement = requirement;
    return this;
  }

  public void setRequirement(String requirement) {
    this.requirement = requirement;
  }

  public RunState getState() {
    return state;
  }

  public Problem state(RunState state) {
    this.state = state;
    return this;
  }

  public void setState(RunState state) {
    this.state = state;
  }

  public Long getExpectedSeq() {
    return expectedSeq;
  }

  public Problem expectedSeq(Long expectedSeq) {
    this.expectedSeq = expectedSeq;
    return this;
  }

  public void setExpectedSeq(Long expectedSeq) {
    this.expectedSeq = expectedSeq;
  }

  /** What ended the session, as far as the server still knows; &#x60;unknown&#x60; after a restart, and for a session that was taken over and whose successor has ended. */
  public String getEndedBy() {
    return endedBy;
  }

  public Problem endedBy(String endedBy) {
    this.endedBy = endedBy;
    return this;
  }

  public void setEndedBy(String endedBy) {
    this.endedBy = endedBy;
  }

  public static Problem fromJson(String text) {
    return JSON.getGson().fromJson(text, Problem.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
