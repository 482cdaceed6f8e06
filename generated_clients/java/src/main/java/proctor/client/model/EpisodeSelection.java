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

/** The part of a benchmark that is played, all of it where a member is absent; for the profile &#x60;subsets&#x60;. */
public class EpisodeSelection {
  @SerializedName("tasks")
  private List<String> tasks;

  @SerializedName("splits")
  private List<String> splits;

  public List<String> getTasks() {
    return tasks;
  }

  public EpisodeSelection tasks(List<String> tasks) {
    this.tasks = tasks;
    return this;
  }

  public void setTasks(List<String> tasks) {
    this.tasks = tasks;
  }

  public List<String> getSplits() {
    return splits;
  }

  public EpisodeSelection splits(List<String> splits) {
    this.splits = splits;
    return this;
  }

  public void setSplits(List<String> splits) {
    this.splits = splits;
  }

  public static EpisodeSelection fromJson(String text) {
    return JSON.getGson().fromJson(text, EpisodeSelection.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
