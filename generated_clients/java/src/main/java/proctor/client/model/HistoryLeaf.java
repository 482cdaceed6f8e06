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

public class HistoryLeaf {
  @SerializedName("index")
  @javax.annotation.Nonnull
  private Long index;

  @SerializedName("leaf")
  @javax.annotation.Nonnull
  private String leaf;

  public Long getIndex() {
    return index;
  }

  public HistoryLeaf index(Long index) {
    this.index = index;
    return this;
  }

  public void setIndex(Long index) {
    this.index = index;
  }

  /** A JSON text, whose UTF-8 is what the tree has; board.md has its members. */
  public String getLeaf() {
    return leaf;
  }

  public HistoryLeaf leaf(String leaf) {
    this.leaf = leaf;
    return this;
  }

  public void setLeaf(String leaf) {
    this.leaf = leaf;
  }

  public static HistoryLeaf fromJson(String text) {
    return JSON.getGson().fromJson(text, HistoryLeaf.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
