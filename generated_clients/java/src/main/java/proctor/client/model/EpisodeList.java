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

public class EpisodeList {
  @SerializedName("episodes")
  @javax.annotation.Nonnull
  private List<Episode> episodes;

  @SerializedName("next_cursor")
  private String nextCursor;

  public List<Episode> getEpisodes() {
    return episodes;
  }

  public EpisodeList episodes(List<Episode> episodes) {
    this.episodes = episodes;
    return this;
  }

  public void setEpisodes(List<Episode> episodes) {
    this.episodes = episodes;
  }

  public String getNextCursor() {
    return nextCursor;
  }

  public EpisodeList nextCursor(String nextCursor) {
    this.nextCursor = nextCursor;
    return this;
  }

  public void setNextCursor(String nextCursor) {
    this.nextCursor = nextCursor;
  }

  public static EpisodeList fromJson(String text) {
    return JSON.getGson().fromJson(text, EpisodeList.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
