/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


package proctor.client.model;

import com.google.gson.annotations.SerializedName;

/** &#x60;pull&#x60; when absent: workers attach and predict. &#x60;push&#x60;: the server calls the policy itself, and workers of the run are its own. */
public enum RunMode {
  @SerializedName("pull")
  PULL("pull"),
  @SerializedName("push")
  PUSH("push");

  private final String value;

  RunMode(String value) {
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
