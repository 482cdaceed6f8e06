/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


package proctor.client.model;

import com.google.gson.annotations.SerializedName;

public enum SideEffects {
  @SerializedName("none")
  NONE("none"),
  @SerializedName("possible")
  POSSIBLE("possible");

  private final String value;

  SideEffects(String value) {
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
