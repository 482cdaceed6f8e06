/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


package proctor.client.model;

import com.google.gson.annotations.SerializedName;

public enum EpisodeStatus {
  @SerializedName("pending")
  PENDING("pending"),
  @SerializedName("in_progress")
  IN_PROGRESS("in_progress"),
  @SerializedName("scored")
  SCORED("scored");

  private final String value;

  EpisodeStatus(String value) {
    this.value = value;
  }

  public String getValue() {
    return value;
  }

  @Override
  public String toString() {
    return value;
  }
}
