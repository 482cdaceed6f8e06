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

public class Lease {
  @SerializedName("expires_at")
  @javax.annotation.Nonnull
  private OffsetDateTime expiresAt;

  @SerializedName("idle_timeout_s")
  @javax.annotation.Nonnull
  private Double idleTimeoutS;

  public OffsetDateTime getExpiresAt() {
    return expiresAt;
  }

  public Lease expiresAt(OffsetDateTime expiresAt) {
    this.expiresAt = expiresAt;
    return this;
  }

  public void setExpiresAt(OffsetDateTime expiresAt) {
    this.expiresAt = expiresAt;
  }

  public Double getIdleTimeoutS() {
    return idleTimeoutS;
  }

  public Lease idleTimeoutS(Double idleTimeoutS) {
    this.idleTimeoutS = idleTimeoutS;
    return this;
  }

  public void setIdleTimeoutS(Double idleTimeoutS) {
    this.idleTimeoutS = idleTimeoutS;
  }

  public static Lease fromJson(String text) {
    return JSON.getGson().fromJson(text, Lease.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
