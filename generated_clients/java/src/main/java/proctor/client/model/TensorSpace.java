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

public class TensorSpace {
  @SerializedName("dtype")
  @javax.annotation.Nonnull
  private String dtype;

  @SerializedName("shape")
  @javax.annotation.Nonnull
  private List<Integer> shape;

  @SerializedName("description")
  @javax.annotation.Nonnull
  private String description;

  @SerializedName("tasks")
  private List<String> tasks;

  public String getDtype() {
    return dtype;
  }

  public TensorSpace dtype(String dtype) {
    this.dtype = dtype;
    return this;
  }

  public void setDtype(String dtype) {
    this.dtype = dtype;
  }

  public List<Integer> getShape() {
    return shape;
  }

  public TensorSpace shape(List<Integer> shape) {
    this.shape = shape;
    return this;
  }

  public void setShape(List<Integer> shape) {
    this.shape = shape;
  }

  public String getDescription() {
    return description;
  }

  public TensorSpace description(String description) {
    this.description = description;
    return this;
  }

  public void setDescription(String description) {
    this.description = description;
  }

  public List<String> getTasks() {
    return tasks;
  }

  public TensorSpace tasks(List<String> tasks) {
    this.tasks = tasks;
    return this;
  }

  public void setTasks(List<String> tasks) {
    this.tasks = tasks;
  }

  public static TensorSpace fromJson(String text) {
    return JSON.getGson().fromJson(text, TensorSpace.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
