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

/** 95 % interval. */
public class Interval {
  @SerializedName("low")
  @javax.annotation.Nonnull
  private Double low;

  @SerializedName("high")
  @javax.annotation.Nonnull
  private Double high;

  public Double getLow() {
    return low;
  }

  public Interval low(Double low) {
    this.low = low;
    return this;
  }

  public void setLow(Double low) {
    this.low = low;
  }

  public Double getHigh() {
    return high;
  }

  public Interval high(Double high) {
    this.high = high;
    return this;
  }

  public void setHigh(Double high) {
    this.high = high;
  }

  public static Interval fromJson(String text) {
    return JSON.getGson().fromJson(text, Interval.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
