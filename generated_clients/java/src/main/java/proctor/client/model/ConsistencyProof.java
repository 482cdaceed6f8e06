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

public class ConsistencyProof {
  @SerializedName("old_size")
  @javax.annotation.Nonnull
  private Long oldSize;

  @SerializedName("new_size")
  @javax.annotation.Nonnull
  private Long newSize;

  @SerializedName("hashes")
  @javax.annotation.Nonnull
  private List<String> hashes;

  public Long getOldSize() {
    return oldSize;
  }

  public ConsistencyProof oldSize(Long oldSize) {
    this.oldSize = oldSize;
    return this;
  }

  public void setOldSize(Long oldSize) {
    this.oldSize = oldSize;
  }

  public Long getNewSize() {
    return newSize;
  }

  public ConsistencyProof newSize(Long newSize) {
    this.newSize = newSize;
    return this;
  }

  public void setNewSize(Long newSize) {
    this.newSize = newSize;
  }

  public List<String> getHashes() {
    return hashes;
  }

  public ConsistencyProof hashes(List<String> hashes) {
    this.hashes = hashes;
    return this;
  }

  public void setHashes(List<String> hashes) {
    this.hashes = hashes;
  }

  public static ConsistencyProof fromJson(String text) {
    return JSON.getGson().fromJson(text, ConsistencyProof.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
