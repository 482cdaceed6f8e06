/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


package proctor.client.model;

import com.google.gson.annotations.SerializedName;

/** &#x60;abort&#x60; when absent. */
public enum StopMode {
  @SerializedName("abort")
  ABORT("abort"),
  @SerializedName("drain")
  DRAIN("drain");

  private final String value;

  StopMode(String value) {
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
