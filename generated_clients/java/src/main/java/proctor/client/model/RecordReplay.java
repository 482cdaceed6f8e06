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

/** As in a verdict (record.md); absent before the end of the replay, and where there is none. */
public class RecordReplay {
  @SerializedName("result")
  @javax.annotation.Nonnull
  private String result;

  @SerializedName("episodes")
  @javax.annotation.Nonnull
  private Integer episodes;

  @SerializedName("exact")
  @javax.annotation.Nonnull
  private Integer exact;

  @SerializedName("outcome")
  @javax.annotation.Nonnull
  private Integer outcome;

  @SerializedName("diverged")
  @javax.annotation.Nonnull
  private Integer diverged;

  @SerializedName("first_divergence")
  private ReplayDivergence firstDivergence;

  /** &#x60;exact&#x60;, &#x60;outcome&#x60; or &#x60;diverged&#x60;. */
  public String getResult() {
    return result;
  }

  public RecordReplay result(String result) {
    this.result = result;
    return this;
  }

  public void setResult(String result) {
    this.result = result;
  }

  public Integer getEpisodes() {
    return episodes;
  }

  public RecordReplay episodes(Integer episodes) {
    this.episodes = episodes;
    return this;
  }

  public void setEpisodes(Integer episodes) {
    this.episodes = episodes;
  }

  public Integer getExact() {
    return exact;
  }

  public RecordReplay exact(Integer exact) {
    this.exact = exact;
    return this;
  }

  public void setExact(Integer exact) {
    this.exact = exact;
  }

  public Integer getOutcome() {
    return outcome;
  }

  public RecordReplay outcome(Integer outcome) {
    this.outcome = outcome;
    return this;
  }

  public void setOutcome(Integer outcome) {
    this.outcome = outcome;
  }

  public Integer getDiverged() {
    return diverged;
  }

  public RecordReplay diverged(Integer diverged) {
    this.diverged = diverged;
    return this;
  }

  public void setDiverged(Integer diverged) {
    this.diverged = diverged;
  }

  public ReplayDivergence getFirstDivergence() {
    return firstDivergence;
  }

  public RecordReplay firstDivergence(ReplayDivergence firstDivergence) {
    this.firstDivergence = firstDivergence;
    return this;
  }

  public void setFirstDivergence(ReplayDivergence firstDivergence) {
    this.firstDivergence = firstDivergence;
  }

  public static RecordReplay fromJson(String text) {
    return JSON.getGson().fromJson(text, RecordReplay.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
