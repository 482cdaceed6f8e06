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

/** The ranks that an entry may have; absent for an entry that is flagged. */
public class RankInterval {
  @SerializedName("low")
  @javax.annotation.Nonnull
  private Integer low;

  @SerializedName("high")
  @javax.annotation.Nonnull
  private Integer high;

  /** The best one. */
  public Integer getLow() {
    return low;
  }

  public RankInterval low(Integer low) {
    this.low = low;
    return this;
  }

  public void setLow(Integer low) {
    this.low = low;
  }

  /** The worst one. */
  public Integer getHigh() {
    return high;
  }

  public RankInterval high(Integer high) {
    this.high = high;
    return this;
  }

  public void setHigh(Integer high) {
    this.high = high;
  }

  public static RankInterval fromJson(String text) {
    return JSON.getGson().fromJson(text, RankInterval.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
