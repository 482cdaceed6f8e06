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

public class PublicKey {
  @SerializedName("keyid")
  @javax.annotation.Nonnull
  private String keyid;

  @SerializedName("algorithm")
  @javax.annotation.Nonnull
  private String algorithm;

  @SerializedName("public_key")
  @javax.annotation.Nonnull
  private String publicKey;

  @SerializedName("created_at")
  @javax.annotation.Nonnull
  private OffsetDateTime createdAt;

  @SerializedName("retired_at")
  private OffsetDateTime retiredAt;

  /** &#x60;SHA256:&#x60; and the SHA-256 of the key in hexadecimal digits. */
  public String getKeyid() {
    return keyid;
  }

  public PublicKey keyid(String keyid) {
    this.keyid = keyid;
    return this;
  }

  public void setKeyid(String keyid) {
    this.keyid = keyid;
  }

  /** &#x60;ed25519&#x60;, or another one of a later version. */
  public String getAlgorithm() {
    return algorithm;
  }

  public PublicKey algorithm(String algorithm) {
    this.algorithm = algorithm;
    return this;
  }

  public void setAlgorithm(String algorithm) {
    this.algorithm = algorithm;
  }

  /** Its 32 bytes. */
  public String getPublicKey() {
    return publicKey;
  }

  public PublicKey publicKey(String publicKey) {
    this.publicKey = publicKey;
    return this;
  }

  public void setPublicKey(String publicKey) {
    this.publicKey = publicKey;
  }

  public OffsetDateTime getCreatedAt() {
    return createdAt;
  }

  public PublicKey createdAt(OffsetDateTime createdAt) {
    this.createdAt = createdAt;
    return this;
  }

  public void setCreatedAt(OffsetDateTime createdAt) {
    this.createdAt = createdAt;
  }

  /** When it signed for the last time; null for the key in use. */
  public OffsetDateTime getRetiredAt() {
    return retiredAt;
  }

  public PublicKey retiredAt(OffsetDateTime retiredAt) {
    this.retiredAt = retiredAt;
    return this;
  }

  public void setRetiredAt(OffsetDateTime retiredAt) {
    this.retiredAt = retiredAt;
  }

  public static PublicKey fromJson(String text) {
    return JSON.getGson().fromJson(text, PublicKey.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
