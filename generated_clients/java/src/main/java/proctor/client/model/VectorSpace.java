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

/** One named vector of numbers, with every convention a policy could get wrong. */
public class VectorSpace {
  @SerializedName("size")
  @javax.annotation.Nonnull
  private Integer size;

  @SerializedName("unit")
  @javax.annotation.Nonnull
  private String unit;

  @SerializedName("rotation")
  @javax.annotation.Nonnull
  private String rotation;

  @SerializedName("frame")
  @javax.annotation.Nonnull
  private String frame;

  @SerializedName("relative")
  @javax.annotation.Nonnull
  private Boolean relative;

  @SerializedName("gripper_open")
  private Double gripperOpen;

  @SerializedName("minimum")
  private List<Double> minimum;

  @SerializedName("maximum")
  private List<Double> maximum;

  @SerializedName("out_of_range")
  @javax.annotation.Nonnull
  private String outOfRange;

  @SerializedName("description")
  private String description;

  @SerializedName("tasks")
  private List<String> tasks;

  public Integer getSize() {
    return size;
  }

  public VectorSpace size(Integer size) {
    this.size = size;
    return this;
  }

  public void setSize(Integer size) {
    this.size = size;
  }

  /** &#x60;rad&#x60;, &#x60;m&#x60;, &#x60;1&#x60;, or several joined by commas. */
  public String getUnit() {
    return unit;
  }

  public VectorSpace unit(String unit) {
    this.unit = unit;
    return this;
  }

  public void setUnit(String unit) {
    this.unit = unit;
  }

  public String getRotation() {
    return rotation;
  }

  public VectorSpace rotation(String rotation) {
    this.rotation = rotation;
    return this;
  }

  public void setRotation(String rotation) {
    this.rotation = rotation;
  }

  /** &#x60;world&#x60;, &#x60;base&#x60;, &#x60;tool&#x60;, &#x60;joint&#x60;, or &#x60;none&#x60;. */
  public String getFrame() {
    return frame;
  }

  public VectorSpace frame(String frame) {
    this.frame = frame;
    return this;
  }

  public void setFrame(String frame) {
    this.frame = frame;
  }

  /** True when the values are increments. */
  public Boolean getRelative() {
    return relative;
  }

  public VectorSpace relative(Boolean relative) {
    this.relative = relative;
    return this;
  }

  public void setRelative(Boolean relative) {
    this.relative = relative;
  }

  /** The value that means fully open. */
  public Double getGripperOpen() {
    return gripperOpen;
  }

  public VectorSpace gripperOpen(Double gripperOpen) {
    this.gripperOpen = gripperOpen;
    return this;
  }

  public void setGripperOpen(Double gripperOpen) {
    this.gripperOpen = gripperOpen;
  }

  public List<Double> getMinimum() {
    return minimum;
  }

  public VectorSpace minimum(List<Double> minimum) {
    this.minimum = minimum;
    return this;
  }

  public void setMinimum(List<Double> minimum) {
    this.minimum = minimum;
  }

  public List<Double> getMaximum() {
    return maximum;
  }

  public VectorSpace maximum(List<Double> maximum) {
    this.maximum = maximum;
    return this;
  }

  public void setMaximum(List<Double> maximum) {
    this.maximum = maximum;
  }

  public String getOutOfRange() {
    return outOfRange;
  }

  public VectorSpace outOfRange(String outOfRange) {
    this.outOfRange = outOfRange;
    return this;
  }

  public void setOutOfRange(String outOfRange) {
    this.outOfRange = outOfRange;
  }

  /** What the numbers are. */
  public String getDescription() {
    return description;
  }

  public VectorSpace description(String description) {
    this.description = description;
    return this;
  }

  public void setDescription(String description) {
    this.description = description;
  }

  /** The tasks that have this entry; all of them when absent. */
  public List<String> getTasks() {
    return tasks;
  }

  public VectorSpace tasks(List<String> tasks) {
    this.tasks = tasks;
    return this;
  }

  public void setTasks(List<String> tasks) {
    this.tasks = tasks;
  }

  public static VectorSpace fromJson(String text) {
    return JSON.getGson().fromJson(text, VectorSpace.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
