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

public class ProtocolRange {
  @SerializedName("min")
  @javax.annotation.Nonnull
  private String min;

  @SerializedName("max")
  @javax.annotation.Nonnull
  private String max;

  public String getMin() {
    return min;
  }

  public ProtocolRange min(String min) {
    this.min = min;
    return this;
  }

  public void setMin(String min) {
    this.min = min;
  }

  public String getMax() {
    return max;
  }

  public ProtocolRange max(String max) {
    this.max = max;
    return this;
  }

  public void setMax(String max) {
    this.max = max;
  }

  public static ProtocolRange fromJson(String text) {
    return JSON.getGson().fromJson(text, ProtocolRange.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
