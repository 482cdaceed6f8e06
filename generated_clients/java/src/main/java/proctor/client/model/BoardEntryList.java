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

public class BoardEntryList {
  @SerializedName("entries")
  @javax.annotation.Nonnull
  private List<BoardEntry> entries;

  @SerializedName("next_cursor")
  private String nextCursor;

  public List<BoardEntry> getEntries() {
    return entries;
  }

  public BoardEntryList entries(List<BoardEntry> entries) {
    this.entries = entries;
    return this;
  }

  public void setEntries(List<BoardEntry> entries) {
    this.entries = entries;
  }

  public String getNextCursor() {
    return nextCursor;
  }

  public BoardEntryList nextCursor(String nextCursor) {
    this.nextCursor = nextCursor;
    return this;
  }

  public void setNextCursor(String nextCursor) {
    this.nextCursor = nextCursor;
  }

  public static BoardEntryList fromJson(String text) {
    return JSON.getGson().fromJson(text, BoardEntryList.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
