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

/** The simulator broke; the episode began again, at no cost to the policy. Nothing of the chunk counts as executed. A turn that ends an episode has its result instead, and &#x60;list_episodes&#x60; the faults of the next one. */
public class Fault {
  @SerializedName("episode_id")
  @javax.annotation.Nonnull
  private String episodeId;

  @SerializedName("faults")
  @javax.annotation.Nonnull
  private Integer faults;

  @SerializedName("detail")
  @javax.annotation.Nonnull
  private String detail;

  public String getEpisodeId() {
    return episodeId;
  }

  public Fault episodeId(String episodeId) {
    this.episodeId = episodeId;
    return this;
  }

  public void setEpisodeId(String episodeId) {
    this.episodeId = episodeId;
  }

  /** Faults of this episode so far. */
  public Integer getFaults() {
    return faults;
  }

  public Fault faults(Integer faults) {
    this.faults = faults;
    return this;
  }

  public void setFaults(Integer faults) {
    this.faults = faults;
  }

  public String getDetail() {
    return detail;
  }

  public Fault detail(String detail) {
    this.detail = detail;
    return this;
  }

  public void setDetail(String detail) {
    this.detail = detail;
  }

  public static Fault fromJson(String text) {
    return JSON.getGson().fromJson(text, Fault.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
