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

/** The episode that the observation belongs to. */
public class EpisodeView {
  @SerializedName("episode_id")
  @javax.annotation.Nonnull
  private String episodeId;

  @SerializedName("index")
  @javax.annotation.Nonnull
  private Integer index;

  @SerializedName("task")
  @javax.annotation.Nonnull
  private String task;

  @SerializedName("instruction")
  @javax.annotation.Nonnull
  private String instruction;

  @SerializedName("attempt")
  @javax.annotation.Nonnull
  private Integer attempt;

  @SerializedName("step")
  @javax.annotation.Nonnull
  private Integer step;

  @SerializedName("max_steps")
  @javax.annotation.Nonnull
  private Integer maxSteps;

  public String getEpisodeId() {
    return episodeId;
  }

  public EpisodeView episodeId(String episodeId) {
    this.episodeId = episodeId;
    return this;
  }

  public void setEpisodeId(String episodeId) {
    this.episodeId = episodeId;
  }

  /** Position in the manifest. */
  public Integer getIndex() {
    return index;
  }

  public EpisodeView index(Integer index) {
    this.index = index;
    return this;
  }

  public void setIndex(Integer index) {
    this.index = index;
  }

  public String getTask() {
    return task;
  }

  public EpisodeView task(String task) {
    this.task = task;
    return this;
  }

  public void setTask(String task) {
    this.task = task;
  }

  public String getInstruction() {
    return instruction;
  }

  public EpisodeView instruction(String instruction) {
    this.instruction = instruction;
    return this;
  }

  public void setInstruction(String instruction) {
    this.instruction = instruction;
  }

  public Integer getAttempt() {
    return attempt;
  }

  public EpisodeView attempt(Integer attempt) {
    this.attempt = attempt;
    return this;
  }

  public void setAttempt(Integer attempt) {
    this.attempt = attempt;
  }

  public Integer getStep() {
    return step;
  }

  public EpisodeView step(Integer step) {
    this.step = step;
    return this;
  }

  public void setStep(Integer step) {
    this.step = step;
  }

  public Integer getMaxSteps() {
    return maxSteps;
  }

  public EpisodeView maxSteps(Integer maxSteps) {
    this.maxSteps = maxSteps;
    return this;
  }

  public void setMaxSteps(Integer maxSteps) {
    this.maxSteps = maxSteps;
  }

  public static EpisodeView fromJson(String text) {
    return JSON.getGson().fromJson(text, EpisodeView.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
