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

public class EpisodeResult {
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

  @SerializedName("seed")
  private Long seed;

  @SerializedName("attempt")
  @javax.annotation.Nonnull
  private Integer attempt;

  @SerializedName("faults")
  @javax.annotation.Nonnull
  private Integer faults;

  @SerializedName("outcome")
  @javax.annotation.Nonnull
  private Outcome outcome;

  @SerializedName("score")
  @javax.annotation.Nonnull
  private Double score;

  @SerializedName("steps")
  @javax.annotation.Nonnull
  private Integer steps;

  @SerializedName("terminated")
  @javax.annotation.Nonnull
  private Boolean terminated;

  @SerializedName("truncated")
  @javax.annotation.Nonnull
  private Boolean truncated;

  @SerializedName("think_s")
  @javax.annotation.Nonnull
  private Double thinkS;

  @SerializedName("finished_at")
  @javax.annotation.Nonnull
  private OffsetDateTime finishedAt;

  @SerializedName("player")
  private PlayerView player;

  @SerializedName("clipped_actions")
  private Integer clippedActions;

  @SerializedName("total_reward")
  private Double totalReward;

  public String getEpisodeId() {
    return episodeId;
  }

  public EpisodeResult episodeId(String episodeId) {
    this.episodeId = episodeId;
    return this;
  }

  public void setEpisodeId(String episodeId) {
    this.episodeId = episodeId;
  }

  public Integer getIndex() {
    return index;
  }

  public EpisodeResult index(Integer index) {
    this.index = index;
    return this;
  }

  public void setIndex(Integer index) {
    this.index = index;
  }

  public String getTask() {
    return task;
  }

  public EpisodeResult task(String task) {
    this.task = task;
    return this;
  }

  public void setTask(String task) {
    this.task = task;
  }

  public String getSplit() {
    return split;
  }

  public EpisodeResult split(String split) {
    this.split = split;
    return this;
  }

  public void setSplit(String split) {
    this.split = split;
  }

  /** Absent where &#x60;sealed_splits&#x60; of the benchmark names the split. */
  public Long getSeed() {
    return seed;
  }

  public EpisodeResult seed(Long seed) {
    this.seed = seed;
    return this;
  }

  public void setSeed(Long seed) {
    this.seed = seed;
  }

  public Integer getAttempt() {
    return attempt;
  }

  public EpisodeResult attempt(Integer attempt) {
    this.attempt = attempt;
    return this;
  }

  public void setAttempt(Integer attempt) {
    this.attempt = attempt;
  }

  public Integer getFaults() {
    return faults;
  }

  public EpisodeResult faults(Integer faults) {
    this.faults = faults;
    return this;
  }

  public void setFaults(Integer faults) {
    this.faults = faults;
  }

  public Outcome getOutcome() {
    return outcome;
  }

  public EpisodeResult outcome(Outcome outcome) {
    this.outcome = outcome;
    return this;
  }

  public void setOutcome(Outcome outcome) {
    this.outcome = outcome;
  }

  public Double getScore() {
    return score;
  }

  public EpisodeResult score(Double score) {
    this.score = score;
    return this;
  }

  public void setScore(Double score) {
    this.score = score;
  }

  public Integer getSteps() {
    return steps;
  }

  public EpisodeResult steps(Integer steps) {
    this.steps = steps;
    return this;
  }

  public void setSteps(Integer steps) {
    this.steps = steps;
  }

  public Boolean getTerminated() {
    return terminated;
  }

  public EpisodeResult terminated(Boolean terminated) {
    this.terminated = terminated;
    return this;
  }

  public void setTerminated(Boolean terminated) {
    this.terminated = terminated;
  }

  public Boolean getTruncated() {
    return truncated;
  }

  public EpisodeResult truncated(Boolean truncated) {
    this.truncated = truncated;
    return this;
  }

  public void setTruncated(Boolean truncated) {
    this.truncated = truncated;
  }

  /** Time between turns that the policy took. */
  public Double getThinkS() {
    return thinkS;
  }

  public EpisodeResult thinkS(Double thinkS) {
    this.thinkS = thinkS;
    return this;
  }

  public void setThinkS(Double thinkS) {
    this.thinkS = thinkS;
  }

  public OffsetDateTime getFinishedAt() {
    return finishedAt;
  }

  public EpisodeResult finishedAt(OffsetDateTime finishedAt) {
    this.finishedAt = finishedAt;
    return this;
  }

  public void setFinishedAt(OffsetDateTime finishedAt) {
    this.finishedAt = finishedAt;
  }

  public PlayerView getPlayer() {
    return player;
  }

  public EpisodeResult player(PlayerView player) {
    this.player = player;
    return this;
  }

  public void setPlayer(PlayerView player) {
    this.player = player;
  }

  /** Actions of the attempt with a number outside of a range that is declared &#x60;clip&#x60;; for the profile &#x60;attribution&#x60;. */
  public Integer getClippedActions() {
    return clippedActions;
  }

  public EpisodeResult clippedActions(Integer clippedActions) {
    this.clippedActions = clippedActions;
    return this;
  }

  public void setClippedActions(Integer clippedActions) {
    this.clippedActions = clippedActions;
  }

  /** Sum of the rewards of the attempt, its return; for the profile &#x60;attribution&#x60;. */
  public Double getTotalReward() {
    return totalReward;
  }

  public EpisodeResult totalReward(Double totalReward) {
    this.totalReward = totalReward;
    return this;
  }

  public void setTotalReward(Double totalReward) {
    this.totalReward = totalReward;
  }

  public static EpisodeResult fromJson(String text) {
    return JSON.getGson().fromJson(text, EpisodeResult.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
