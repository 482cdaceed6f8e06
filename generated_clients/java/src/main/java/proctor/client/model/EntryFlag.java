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

public class EntryFlag {
  @SerializedName("reason")
  @javax.annotation.Nonnull
  private String reason;

  @SerializedName("flagged_at")
  @javax.annotation.Nonnull
  private OffsetDateTime flaggedAt;

  public String getReason() {
    return reason;
  }

  public EntryFlag reason(String reason) {
    this.reason = reason;
    return this;
  }

  public void setReason(String reason) {
    this.reason = reason;
  }

  public OffsetDateTime getFlaggedAt() {
    return flaggedAt;
  }

  public EntryFlag flaggedAt(OffsetDateTime flaggedAt) {
    this.flaggedAt = flaggedAt;
    return this;
  }

  public void setFlaggedAt(OffsetDateTime flaggedAt) {
    this.flaggedAt = flaggedAt;
  }

  public static EntryFlag fromJson(String text) {
    return JSON.getGson().fromJson(text, EntryFlag.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
