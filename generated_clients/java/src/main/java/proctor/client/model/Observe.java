/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


package proctor.client.model;

import com.google.gson.annotations.SerializedName;

/** &#x60;last&#x60; when absent; &#x60;all&#x60; adds the observation after every executed action. */
public enum Observe {
  @SerializedName("last")
  LAST("last"),
  @SerializedName("all")
  ALL("all");

  private final String value;

  Observe(String value) {
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
