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

public class Progress {
  @SerializedName("episodes_total")
  @javax.annotation.Nonnull
  private Integer episodesTotal;

  @SerializedName("episodes_scored")
  @javax.annotation.Nonnull
  private Integer episodesScored;

  @SerializedName("episodes_in_progress")
  @javax.annotation.Nonnull
  private Integer episodesInProgress;

  @SerializedName("episodes_pending")
  @javax.annotation.Nonnull
  private Integer episodesPending;

  public Integer getEpisodesTotal() {
    return episodesTotal;
  }

  public Progress episodesTotal(Integer episodesTotal) {
    this.episodesTotal = episodesTotal;
    return this;
  }

  public void setEpisodesTotal(Integer episodesTotal) {
    this.episodesTotal = episodesTotal;
  }

  /** Abandoned ones included. */
  public Integer getEpisodesScored() {
    return episodesScored;
  }

  public Progress episodesScored(Integer episodesScored) {
    this.episodesScored = episodesScored;
    return this;
  }

  public void setEpisodesScored(Integer episodesScored) {
    this.episodesScored = episodesScored;
  }

  public Integer getEpisodesInProgress() {
    return episodesInProgress;
  }

  public Progress episodesInProgress(Integer episodesInProgress) {
    this.episodesInProgress = episodesInProgress;
    return this;
  }

  public void setEpisodesInProgress(Integer episodesInProgress) {
    this.episodesInProgress = episodesInProgress;
  }

  public Integer getEpisodesPending() {
    return episodesPending;
  }

  public Progress episodesPending(Integer episodesPending) {
    this.episodesPending = episodesPending;
    return this;
  }

  public void setEpisodesPending(Integer episodesPending) {
    this.episodesPending = episodesPending;
  }

  public static Progress fromJson(String text) {
    return JSON.getGson().fromJson(text, Progress.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
