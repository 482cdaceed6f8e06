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

public class HistoryPage {
  @SerializedName("leaves")
  @javax.annotation.Nonnull
  private List<HistoryLeaf> leaves;

  @SerializedName("next_cursor")
  private String nextCursor;

  public List<HistoryLeaf> getLeaves() {
    return leaves;
  }

  public HistoryPage leaves(List<HistoryLeaf> leaves) {
    this.leaves = leaves;
    return this;
  }

  public void setLeaves(List<HistoryLeaf> leaves) {
    this.leaves = leaves;
  }

  public String getNextCursor() {
    return nextCursor;
  }

  public HistoryPage nextCursor(String nextCursor) {
    this.nextCursor = nextCursor;
    return this;
  }

  public void setNextCursor(String nextCursor) {
    this.nextCursor = nextCursor;
  }

  public static HistoryPage fromJson(String text) {
    return JSON.getGson().fromJson(text, HistoryPage.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
