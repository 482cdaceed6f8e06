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

public class InclusionProof {
  @SerializedName("leaf_index")
  @javax.annotation.Nonnull
  private Long leafIndex;

  @SerializedName("tree_size")
  @javax.annotation.Nonnull
  private Long treeSize;

  @SerializedName("hashes")
  @javax.annotation.Nonnull
  private List<String> hashes;

  public Long getLeafIndex() {
    return leafIndex;
  }

  public InclusionProof leafIndex(Long leafIndex) {
    this.leafIndex = leafIndex;
    return this;
  }

  public void setLeafIndex(Long leafIndex) {
    this.leafIndex = leafIndex;
  }

  public Long getTreeSize() {
    return treeSize;
  }

  public InclusionProof treeSize(Long treeSize) {
    this.treeSize = treeSize;
    return this;
  }

  public void setTreeSize(Long treeSize) {
    this.treeSize = treeSize;
  }

  public List<String> getHashes() {
    return hashes;
  }

  public InclusionProof hashes(List<String> hashes) {
    this.hashes = hashes;
    return this;
  }

  public void setHashes(List<String> hashes) {
    this.hashes = hashes;
  }

  public static InclusionProof fromJson(String text) {
    return JSON.getGson().fromJson(text, InclusionProof.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
