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

public class KeyList {
  @SerializedName("keys")
  @javax.annotation.Nonnull
  private List<PublicKey> keys;

  public List<PublicKey> getKeys() {
    return keys;
  }

  public KeyList keys(List<PublicKey> keys) {
    this.keys = keys;
    return this;
  }

  public void setKeys(List<PublicKey> keys) {
    this.keys = keys;
  }

  public static KeyList fromJson(String text) {
    return JSON.getGson().fromJson(text, KeyList.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
