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

public class OutcomeCounts {
  @SerializedName("total")
  @javax.annotation.Nonnull
  private Integer total;

  @SerializedName("success")
  @javax.annotation.Nonnull
  private Integer success;

  @SerializedName("failure")
  @javax.annotation.Nonnull
  private Integer failure;

  @SerializedName("abandoned")
  @javax.annotation.Nonnull
  private Integer abandoned;

  @SerializedName("unscored")
  @javax.annotation.Nonnull
  private Integer unscored;

  public Integer getTotal() {
    return total;
  }

  public OutcomeCounts total(Integer total) {
    this.total = total;
    return this;
  }

  public void setTotal(Integer total) {
    this.total = total;
  }

  public Integer getSuccess() {
    return success;
  }

  public OutcomeCounts success(Integer success) {
    this.success = success;
    return this;
  }

  public void setSuccess(Integer success) {
    this.success = success;
  }

  public Integer getFailure() {
    return failure;
  }

  public OutcomeCounts failure(Integer failure) {
    this.failure = failure;
    return this;
  }

  public void setFailure(Integer failure) {
    this.failure = failure;
  }

  public Integer getAbandoned() {
    return abandoned;
  }

  public OutcomeCounts abandoned(Integer abandoned) {
    this.abandoned = abandoned;
    return this;
  }

  public void setAbandoned(Integer abandoned) {
    this.abandoned = abandoned;
  }

  public Integer getUnscored() {
    return unscored;
  }

  public OutcomeCounts unscored(Integer unscored) {
    this.unscored = unscored;
    return this;
  }

  public void setUnscored(Integer unscored) {
    this.unscored = unscored;
  }

  public static OutcomeCounts fromJson(String text) {
    return JSON.getGson().fromJson(text, OutcomeCounts.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
