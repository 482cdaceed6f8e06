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

/** The first state that was another one; absent where every state was met. */
public class ReplayDivergence {
  @SerializedName("episode_index")
  @javax.annotation.Nonnull
  private Integer episodeIndex;

  @SerializedName("attempt")
  @javax.annotation.Nonnull
  private Long attempt;

  @SerializedName("step")
  @javax.annotation.Nonnull
  private Long step;

  public Integer getEpisodeIndex() {
    return episodeIndex;
  }

  public ReplayDivergence episodeIndex(Integer episodeIndex) {
    this.episodeIndex = episodeIndex;
    return this;
  }

  public void setEpisodeIndex(Integer episodeIndex) {
    this.episodeIndex = episodeIndex;
  }

  public Long getAttempt() {
    return attempt;
  }

  public ReplayDivergence attempt(Long attempt) {
    this.attempt = attempt;
    return this;
  }

  public void setAttempt(Long attempt) {
    this.attempt = attempt;
  }

  /** After how many steps of the attempt the state was another one. */
  public Long getStep() {
    return step;
  }

  public ReplayDivergence step(Long step) {
    this.step = step;
    return this;
  }

  public void setStep(Long step) {
    this.step = step;
  }

  public static ReplayDivergence fromJson(String text) {
    return JSON.getGson().fromJson(text, ReplayDivergence.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
