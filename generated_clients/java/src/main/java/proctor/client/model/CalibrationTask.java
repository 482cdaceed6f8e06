/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


package proctor.client.model;

import com.google.gson.annotations.SerializedName;

public enum CalibrationTask {
  @SerializedName("score")
  SCORE("score"),
  @SerializedName("count")
  COUNT("count"),
  @SerializedName("echo")
  ECHO("echo"),
  @SerializedName("delay")
  DELAY("delay"),
  @SerializedName("fault")
  FAULT("fault");

  private final String value;

  CalibrationTask(String value) {
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
