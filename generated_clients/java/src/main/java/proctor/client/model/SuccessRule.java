/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


package proctor.client.model;

import com.google.gson.annotations.SerializedName;

public enum SuccessRule {
  @SerializedName("any_step")
  ANY_STEP("any_step"),
  @SerializedName("last_step")
  LAST_STEP("last_step");

  private final String value;

  SuccessRule(String value) {
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
