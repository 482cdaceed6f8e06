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

public class ComparedTask {
  @SerializedName("paired")
  @javax.annotation.Nonnull
  private Integer paired;

  @SerializedName("baseline_mean")
  private Double baselineMean;

  @SerializedName("mean")
  private Double mean;

  @SerializedName("difference")
  private Double difference;

  public Integer getPaired() {
    return paired;
  }

  public ComparedTask paired(Integer paired) {
    this.paired = paired;
    return this;
  }

  public void setPaired(Integer paired) {
    this.paired = paired;
  }

  public Double getBaselineMean() {
    return baselineMean;
  }

  public ComparedTask baselineMean(Double baselineMean) {
    this.baselineMean = baselineMean;
    return this;
  }

  public void setBaselineMean(Double baselineMean) {
    this.baselineMean = baselineMean;
  }

  public Double getMean() {
    return mean;
  }

  public ComparedTask mean(Double mean) {
    this.mean = mean;
    return this;
  }

  public void setMean(Double mean) {
    this.mean = mean;
  }

  public Double getDifference() {
    return difference;
  }

  public ComparedTask difference(Double difference) {
    this.difference = difference;
    return this;
  }

  public void setDifference(Double difference) {
    this.difference = difference;
  }

  public static ComparedTask fromJson(String text) {
    return JSON.getGson().fromJson(text, ComparedTask.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
