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

/** The &#x60;select&#x60; of a run, as it was submitted. */
public class SelectionView {
  @SerializedName("tasks")
  private List<String> tasks;

  @SerializedName("splits")
  private List<String> splits;

  public List<String> getTasks() {
    return tasks;
  }

  public SelectionView tasks(List<String> tasks) {
    this.tasks = tasks;
    return this;
  }

  public void setTasks(List<String> tasks) {
    this.tasks = tasks;
  }

  public List<String> getSplits() {
    return splits;
  }

  public SelectionView splits(List<String> splits) {
    this.splits = splits;
    return this;
  }

  public void setSplits(List<String> splits) {
    this.splits = splits;
  }

  public static SelectionView fromJson(String text) {
    return JSON.getGson().fromJson(text, SelectionView.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
