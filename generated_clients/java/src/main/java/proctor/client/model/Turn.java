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

/** The answer to attach (seq 0) and to predict. */
public class Turn {
  @SerializedName("session_id")
  @javax.annotation.Nonnull
  private String sessionId;

  @SerializedName("seq")
  @javax.annotation.Nonnull
  private Long seq;

  @SerializedName("episode")
  private EpisodeView episode;

  @SerializedName("observation")
  private Observation observation;

  @SerializedName("observations")
  private List<Observation> observations;

  @SerializedName("executed_steps")
  @javax.annotation.Nonnull
  private Integer executedSteps;

  @SerializedName("stopped_early")
  @javax.annotation.Nonnull
  private Boolean stoppedEarly;

  @SerializedName("rewards")
  @javax.annotation.Nonnull
  private List<Double> rewards;

  @SerializedName("terminated")
  @javax.annotation.Nonnull
  private Boolean terminated;

  @SerializedName("truncated")
  @javax.annotation.Nonnull
  private Boolean truncated;

  @SerializedName("episode_result")
  private EpisodeResult episodeResult;

  @SerializedName("fault")
  private Fault fault;

  @SerializedName("done")
  @javax.annotation.Nonnull
  private Boolean done;

  @SerializedName("lease")
  @javax.annotation.Nonnull
  private Lease lease;

  @SerializedName("timing")
  @javax.annotation.Nonnull
  private Timing timing;

  public String getSessionId() {
    return sessionId;
  }

  public Turn sessionId(String sessionId) {
    this.sessionId = sessionId;
    return this;
  }

  public void setSessionId(String sessionId) {
    this.sessionId = sessionId;
  }

  public Long getSeq() {
    return seq;
  }

  public Turn seq(Long seq) {
    this.seq = seq;
    return this;
  }

  public void setSeq(Long seq) {
    this.seq = seq;
  }

  public EpisodeView getEpisode() {
    return episode;
  }

  public Turn episode(EpisodeView episode) {
    this.episode = episode;
    return this;
  }

  public void setEpisode(EpisodeView episode) {
    this.episode = episode;
  }

  public Observation getObservation() {
    return observation;
  }

  public Turn observation(Observation observation) {
    this.observation = observation;
    return this;
  }

  public void setObservation(Observation observation) {
    this.observation = observation;
  }

  /** With &#x60;observe&#x60; all, one per executed action. */
  public List<Observation> getObservations() {
    return observations;
  }

  public Turn observations(List<Observation> observations) {
    this.observations = observations;
    return this;
  }

  public void setObservations(List<Observation> observations) {
    this.observations = observations;
  }

  public Integer getExecutedSteps() {
    return executedSteps;
  }

  public Turn executedSteps(Integer executedSteps) {
    this.executedSteps = executedSteps;
    return this;
  }

  public void setExecutedSteps(Integer executedSteps) {
    this.executedSteps = executedSteps;
  }

  /** The episode ended before the chunk did. */
  public Boolean getStoppedEarly() {
    return stoppedEarly;
  }

  public Turn stoppedEarly(Boolean stoppedEarly) {
    this.stoppedEarly = stoppedEarly;
    return this;
  }

  public void setStoppedEarly(Boolean stoppedEarly) {
    this.stoppedEarly = stoppedEarly;
  }

  /** One per executed action. */
  public List<Double> getRewards() {
    return rewards;
  }

  public Turn rewards(List<Double> rewards) {
    this.rewards = rewards;
    return this;
  }

  public void setRewards(List<Double> rewards) {
    this.rewards = rewards;
  }

  /** The task ended by itself in this turn. */
  public Boolean getTerminated() {
    return terminated;
  }

  public Turn terminated(Boolean terminated) {
    this.terminated = terminated;
    return this;
  }

  public void setTerminated(Boolean terminated) {
    this.terminated = terminated;
  }

  /** The step limit ended the episode in this turn. */
  public Boolean getTruncated() {
    return truncated;
  }

  public Turn truncated(Boolean truncated) {
    this.truncated = truncated;
    return this;
  }

  public void setTruncated(Boolean truncated) {
    this.truncated = truncated;
  }

  public EpisodeResult getEpisodeResult() {
    return episodeResult;
  }

  public Turn episodeResult(EpisodeResult episodeResult) {
    this.episodeResult = episodeResult;
    return this;
  }

  public void setEpisodeResult(EpisodeResult episodeResult) {
    this.episodeResult = episodeResult;
  }

  public Fault getFault() {
    return fault;
  }

  public Turn fault(Fault fault) {
    this.fault = fault;
    return this;
  }

  public void setFault(Fault fault) {
    this.fault = fault;
  }

  /** No episode is left for this session. It holds no slot any more; its last turn can be repeated until its lease ends. */
  public Boolean getDone() {
    return done;
  }

  public Turn done(Boolean done) {
    this.done = done;
    return this;
  }

  public void setDone(Boolean done) {
    this.done = done;
  }

  public Lease getLease() {
    return lease;
  }

  public Turn lease(Lease lease) {
    this.lease = lease;
    return this;
  }

  public void setLease(Lease lease) {
    this.lease = lease;
  }

  public Timing getTiming() {
    return timing;
  }

  public Turn timing(Timing timing) {
    this.timing = timing;
    return this;
  }

  public void setTiming(Timing timing) {
    this.timing = timing;
  }

  public static Turn fromJson(String text) {
    return JSON.getGson().fromJson(text, Turn.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
