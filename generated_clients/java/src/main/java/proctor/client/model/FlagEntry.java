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

public class FlagEntry {
  @SerializedName("flagged")
  @javax.annotation.Nonnull
  private Boolean flagged;

  @SerializedName("reason")
  @javax.annotation.Nonnull
  private String reason;

  /** False takes the flag back. */
  public Boolean getFlagged() {
    return flagged;
  }

  public FlagEntry flagged(Boolean flagged) {
    this.flagged = flagged;
    return this;
  }

  public void setFlagged(Boolean flagged) {
    this.flagged = flagged;
  }

  /** Shown with the entry. */
  public String getReason() {
    return reason;
  }

  public FlagEntry reason(String reason) {
    this.reason = reason;
    return this;
  }

  public void setReason(String reason) {
    this.reason = reason;
  }

  public static FlagEntry fromJson(String text) {
    return JSON.getGson().fromJson(text, FlagEntry.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
