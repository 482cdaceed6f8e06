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

public class Episode {
  @SerializedName("episode_id")
  @javax.annotation.Nonnull
  private String episodeId;

  @SerializedName("index")
  @javax.annotation.Nonnull
  private Integer index;

  @SerializedName("task")
  @javax.annotation.Nonnull
  private String task;

  @SerializedName("split")
  @javax.annotation.Nonnull
  private String split;

  @SerializedName("status")
  @javax.annotation.Nonnull
  private EpisodeStatus status;

  @SerializedName("attempt")
  @javax.annotation.Nonnull
  private Integer attempt;

  @SerializedName("faults")
  @javax.annotation.Nonnull
  private Integer faults;

  @SerializedName("policy_fault")
  private String policyFault;

  @SerializedName("result")
  private EpisodeResult result;

  public String getEpisodeId() {
    return episodeId;
  }

  public Episode episodeId(String episodeId) {
    this.episodeId = episodeId;
    return this;
  }

  public void setEpisodeId(String episodeId) {
    this.episodeId = episodeId;
  }

  public Integer getIndex() {
    return index;
  }

  public Episode index(Integer index) {
    this.index = index;
    return this;
  }

  public void setIndex(Integer index) {
    this.index = index;
  }

  public String getTask() {
    return task;
  }

  public Episode task(String task) {
    this.task = task;
    return this;
  }

  public void setTask(String task) {
    this.task = task;
  }

  public String getSplit() {
    return split;
  }

  public Episode split(String split) {
    this.split = split;
    return this;
  }

  public void setSplit(String split) {
    this.split = split;
  }

  public EpisodeStatus getStatus() {
    return status;
  }

  public Episode status(EpisodeStatus status) {
    this.status = status;
    return this;
  }

  public void setStatus(EpisodeStatus status) {
    this.status = status;
  }

  /** The current or next attempt. */
  public Integer getAttempt() {
    return attempt;
  }

  public Episode attempt(Integer attempt) {
    this.attempt = attempt;
    return this;
  }

  public void setAttempt(Integer attempt) {
    this.attempt = attempt;
  }

  public Integer getFaults() {
    return faults;
  }

  public Episode faults(Integer faults) {
    this.faults = faults;
    return this;
  }

  public void setFaults(Integer faults) {
    this.faults = faults;
  }

  /** In a run with mode &#x60;push&#x60;: what the policy did wrong when it last ended an attempt of this episode. */
  public String getPolicyFault() {
    return policyFault;
  }

  public Episode policyFault(String policyFault) {
    this.policyFault = policyFault;
    return this;
  }

  public void setPolicyFault(String policyFault) {
    this.policyFault = policyFault;
  }

  public EpisodeResult getResult() {
    return result;
  }

  public Episode result(EpisodeResult result) {
    this.result = result;
    return this;
  }

  public void setResult(EpisodeResult result) {
    this.result = result;
  }

  public static Episode fromJson(String text) {
    return JSON.getGson().fromJson(text, Episode.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
