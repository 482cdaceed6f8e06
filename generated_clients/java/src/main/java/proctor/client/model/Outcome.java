/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


package proctor.client.model;

import com.google.gson.annotations.SerializedName;

public enum Outcome {
  @SerializedName("success")
  SUCCESS("success"),
  @SerializedName("failure")
  FAILURE("failure"),
  @SerializedName("abandoned")
  ABANDONED("abandoned");

  private final String value;

  Outcome(String value) {
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
