/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


package proctor.client.model;

import com.google.gson.annotations.SerializedName;

public enum EntryState {
  @SerializedName("published")
  PUBLISHED("published"),
  @SerializedName("withdrawn")
  WITHDRAWN("withdrawn");

  private final String value;

  EntryState(String value) {
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
