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

public class RunList {
  @SerializedName("runs")
  @javax.annotation.Nonnull
  private List<Run> runs;

  @SerializedName("next_cursor")
  private String nextCursor;

  public List<Run> getRuns() {
    return runs;
  }

  public RunList runs(List<Run> runs) {
    this.runs = runs;
    return this;
  }

  public void setRuns(List<Run> runs) {
    this.runs = runs;
  }

  public String getNextCursor() {
    return nextCursor;
  }

  public RunList nextCursor(String nextCursor) {
    this.nextCursor = nextCursor;
    return this;
  }

  public void setNextCursor(String nextCursor) {
    this.nextCursor = nextCursor;
  }

  public static RunList fromJson(String text) {
    return JSON.getGson().fromJson(text, RunList.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
