/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


package proctor.client.model;

import com.google.gson.annotations.SerializedName;
import java.time.OffsetDateTime;
import java.util.List;
import java.util.Map;
import java.util.Set;
import proctor.client.JSON;

public class StopRun {
  @SerializedName("mode")
  private StopMode mode;

  public StopMode getMode() {
    return mode;
  }

  public StopRun mode(StopMode mode) {
    this.mode = mode;
    return this;
  }

  public void setMode(StopMode mode) {
    this.mode = mode;
  }

  public static StopRun fromJson(String text) {
    return JSON.getGson().fromJson(text, StopRun.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
