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

public class Observation {
  @SerializedName("state")
  @javax.annotation.Nonnull
  private Map<String, List<Double>> state;

  @SerializedName("images")
  @javax.annotation.Nonnull
  private Map<String, Image> images;

  @SerializedName("tensors")
  @javax.annotation.Nonnull
  private Map<String, Tensor> tensors;

  public Map<String, List<Double>> getState() {
    return state;
  }

  public Observation state(Map<String, List<Double>> state) {
    this.state = state;
    return this;
  }

  public void setState(Map<String, List<Double>> state) {
    this.state = state;
  }

  public Map<String, Image> getImages() {
    return images;
  }

  public Observation images(Map<String, Image> images) {
    this.images = images;
    return this;
  }

  public void setImages(Map<String, Image> images) {
    this.images = images;
  }

  public Map<String, Tensor> getTensors() {
    return tensors;
  }

  public Observation tensors(Map<String, Tensor> tensors) {
    this.tensors = tensors;
    return this;
  }

  public void setTensors(Map<String, Tensor> tensors) {
    this.tensors = tensors;
  }

  public static Observation fromJson(String text) {
    return JSON.getGson().fromJson(text, Observation.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
