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

public class Checkpoint {
  @SerializedName("tree_size")
  @javax.annotation.Nonnull
  private Long treeSize;

  @SerializedName("root_sha256")
  @javax.annotation.Nonnull
  private String rootSha256;

  @SerializedName("note")
  @javax.annotation.Nonnull
  private String note;

  @SerializedName("keyid")
  @javax.annotation.Nonnull
  private String keyid;

  public Long getTreeSize() {
    return treeSize;
  }

  public Checkpoint treeSize(Long treeSize) {
    this.treeSize = treeSize;
    return this;
  }

  public void setTreeSize(Long treeSize) {
    this.treeSize = treeSize;
  }

  /** The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software. */
  public String getRootSha256() {
    return rootSha256;
  }

  public Checkpoint rootSha256(String rootSha256) {
    this.rootSha256 = rootSha256;
    return this;
  }

  public void setRootSha256(String rootSha256) {
    this.rootSha256 = rootSha256;
  }

  /** The signed note, which says both as well. */
  public String getNote() {
    return note;
  }

  public Checkpoint note(String note) {
    this.note = note;
    return this;
  }

  public void setNote(String note) {
    this.note = note;
  }

  /** Of the key of &#x60;list_keys&#x60; that signed it. */
  public String getKeyid() {
    return keyid;
  }

  public Checkpoint keyid(String keyid) {
    this.keyid = keyid;
    return this;
  }

  public void setKeyid(String keyid) {
    this.keyid = keyid;
  }

  public static Checkpoint fromJson(String text) {
    return JSON.getGson().fromJson(text, Checkpoint.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
