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

/** An attempt begins; whatever the policy remembers of this session is over. */
public class ResetPolicy {
  @SerializedName("session_id")
  @javax.annotation.Nonnull
  private String sessionId;

  @SerializedName("run_id")
  private String runId;

  @SerializedName("benchmark")
  @javax.annotation.Nonnull
  private Benchmark benchmark;

  @SerializedName("episode")
  @javax.annotation.Nonnull
  private EpisodeView episode;

  public String getSessionId() {
    return sessionId;
  }

  public ResetPolicy sessionId(String sessionId) {
    this.sessionId = sessionId;
    return this;
  }

  public void setSessionId(String sessionId) {
    this.sessionId = sessionId;
  }

  public String getRunId() {
    return runId;
  }

  public ResetPolicy runId(String runId) {
    this.runId = runId;
    return this;
  }

  public void setRunId(String runId) {
    this.runId = runId;
  }

  public Benchmark getBenchmark() {
    return benchmark;
  }

  public ResetPolicy benchmark(Benchmark benchmark) {
    this.benchmark = benchmark;
    return this;
  }

  public void setBenchmark(Benchmark benchmark) {
    this.benchmark = benchmark;
  }

  public EpisodeView getEpisode() {
    return episode;
  }

  public ResetPolicy episode(EpisodeView episode) {
    this.episode = episode;
    return this;
  }

  public void setEpisode(EpisodeView episode) {
    this.episode = episode;
  }

  public static ResetPolicy fromJson(String text) {
    return JSON.getGson().fromJson(text, ResetPolicy.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
