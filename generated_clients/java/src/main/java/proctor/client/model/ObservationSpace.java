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

public class ObservationSpace {
  @SerializedName("state")
  @javax.annotation.Nonnull
  private Map<String, VectorSpace> state;

  @SerializedName("images")
  @javax.annotation.Nonnull
  private Map<String, ImageSpace> images;

  @SerializedName("tensors")
  @javax.annotation.Nonnull
  private Map<String, TensorSpace> tensors;

  public Map<String, VectorSpace> getState() {
    return state;
  }

  public ObservationSpace state(Map<String, VectorSpace> state) {
    this.state = state;
    return this;
  }

  public void setState(Map<String, VectorSpace> state) {
    this.state = state;
  }

  public Map<String, ImageSpace> getImages() {
    return images;
  }

  public ObservationSpace images(Map<String, ImageSpace> images) {
    this.images = images;
    return this;
  }

  public void setImages(Map<String, ImageSpace> images) {
    this.images = images;
  }

  public Map<String, TensorSpace> getTensors() {
    return tensors;
  }

  public ObservationSpace tensors(Map<String, TensorSpace> tensors) {
    this.tensors = tensors;
    return this;
  }

  public void setTensors(Map<String, TensorSpace> tensors) {
    this.tensors = tensors;
  }

  public static ObservationSpace fromJson(String text) {
    return JSON.getGson().fromJson(text, ObservationSpace.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
