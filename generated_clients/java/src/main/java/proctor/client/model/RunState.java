/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


package proctor.client.model;

import com.google.gson.annotations.SerializedName;

public enum RunState {
  @SerializedName("queued")
  QUEUED("queued"),
  @SerializedName("ready")
  READY("ready"),
  @SerializedName("running")
  RUNNING("running"),
  @SerializedName("stopping")
  STOPPING("stopping"),
  @SerializedName("stopped")
  STOPPED("stopped"),
  @SerializedName("failed")
  FAILED("failed"),
  @SerializedName("completed")
  COMPLETED("completed");

  private final String value;

  RunState(String value) {
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
