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

/** The policy is ready for this attempt and no other. */
public class PolicyReset {
  @SerializedName("session_id")
  @javax.annotation.Nonnull
  private String sessionId;

  @SerializedName("episode_id")
  @javax.annotation.Nonnull
  private String episodeId;

  @SerializedName("attempt")
  @javax.annotation.Nonnull
  private Integer attempt;

  public String getSessionId() {
    return sessionId;
  }

  public PolicyReset sessionId(String sessionId) {
    this.sessionId = sessionId;
    return this;
  }

  public void setSessionId(String sessionId) {
    this.sessionId = sessionId;
  }

  public String getEpisodeId() {
    return episodeId;
  }

  public PolicyReset episodeId(String episodeId) {
    this.episodeId = episodeId;
    return this;
  }

  public void setEpisodeId(String episodeId) {
    this.episodeId = episodeId;
  }

  public Integer getAttempt() {
    return attempt;
  }

  public PolicyReset attempt(Integer attempt) {
    this.attempt = attempt;
    return this;
  }

  public void setAttempt(Integer attempt) {
    this.attempt = attempt;
  }

  public static PolicyReset fromJson(String text) {
    return JSON.getGson().fromJson(text, PolicyReset.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
