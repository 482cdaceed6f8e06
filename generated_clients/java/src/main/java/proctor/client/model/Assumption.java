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

public class Assumption {
  @SerializedName("size")
  private Integer size;

  @SerializedName("unit")
  private String unit;

  @SerializedName("rotation")
  private String rotation;

  @SerializedName("frame")
  private String frame;

  @SerializedName("relative")
  private Boolean relative;

  @SerializedName("gripper_open")
  private Double gripperOpen;

  public Integer getSize() {
    return size;
  }

  public Assumption size(Integer size) {
    this.size = size;
    return this;
  }

  public void setSize(Integer size) {
    this.size = size;
  }

  public String getUnit() {
    return unit;
  }

  public Assumption unit(String unit) {
    this.unit = unit;
    return this;
  }

  public void setUnit(String unit) {
    this.unit = unit;
  }

  public String getRotation() {
    return rotation;
  }

  public Assumption rotation(String rotation) {
    this.rotation = rotation;
    return this;
  }

  public void setRotation(String rotation) {
    this.rotation = rotation;
  }

  public String getFrame() {
    return frame;
  }

  public Assumption frame(String frame) {
    this.frame = frame;
    return this;
  }

  public void setFrame(String frame) {
    this.frame = frame;
  }

  public Boolean getRelative() {
    return relative;
  }

  public Assumption relative(Boolean relative) {
    this.relative = relative;
    return this;
  }

  public void setRelative(Boolean relative) {
    this.relative = relative;
  }

  public Double getGripperOpen() {
    return gripperOpen;
  }

  public Assumption gripperOpen(Double gripperOpen) {
    this.gripperOpen = gripperOpen;
    return this;
  }

  public void setGripperOpen(Double gripperOpen) {
    this.gripperOpen = gripperOpen;
  }

  public static Assumption fromJson(String text) {
    return JSON.getGson().fromJson(text, Assumption.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
