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

public class ImageSpace {
  @SerializedName("channels")
  @javax.annotation.Nonnull
  private Integer channels;

  @SerializedName("description")
  @javax.annotation.Nonnull
  private String description;

  @SerializedName("tasks")
  private List<String> tasks;

  public Integer getChannels() {
    return channels;
  }

  public ImageSpace channels(Integer channels) {
    this.channels = channels;
    return this;
  }

  public void setChannels(Integer channels) {
    this.channels = channels;
  }

  public String getDescription() {
    return description;
  }

  public ImageSpace description(String description) {
    this.description = description;
    return this;
  }

  public void setDescription(String description) {
    this.description = description;
  }

  public List<String> getTasks() {
    return tasks;
  }

  public ImageSpace tasks(List<String> tasks) {
    this.tasks = tasks;
    return this;
  }

  public void setTasks(List<String> tasks) {
    this.tasks = tasks;
  }

  public static ImageSpace fromJson(String text) {
    return JSON.getGson().fromJson(text, ImageSpace.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
