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

public class GroupScore {
  @SerializedName("counts")
  @javax.annotation.Nonnull
  private OutcomeCounts counts;

  @SerializedName("mean")
  private Double mean;

  @SerializedName("success_rate")
  private Double successRate;

  public OutcomeCounts getCounts() {
    return counts;
  }

  public GroupScore counts(OutcomeCounts counts) {
    this.counts = counts;
    return this;
  }

  public void setCounts(OutcomeCounts counts) {
    this.counts = counts;
  }

  public Double getMean() {
    return mean;
  }

  public GroupScore mean(Double mean) {
    this.mean = mean;
    return this;
  }

  public void setMean(Double mean) {
    this.mean = mean;
  }

  public Double getSuccessRate() {
    return successRate;
  }

  public GroupScore successRate(Double successRate) {
    this.successRate = successRate;
    return this;
  }

  public void setSuccessRate(Double successRate) {
    this.successRate = successRate;
  }

  public static GroupScore fromJson(String text) {
    return JSON.getGson().fromJson(text, GroupScore.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
