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

/** C order, little-endian; a bool is one byte, 0 or 1. */
public class Tensor {
  @SerializedName("dtype")
  @javax.annotation.Nonnull
  private String dtype;

  @SerializedName("shape")
  @javax.annotation.Nonnull
  private List<Long> shape;

  @SerializedName("data")
  @javax.annotation.Nonnull
  private String data;

  public String getDtype() {
    return dtype;
  }

  public Tensor dtype(String dtype) {
    this.dtype = dtype;
    return this;
  }

  public void setDtype(String dtype) {
    this.dtype = dtype;
  }

  public List<Long> getShape() {
    return shape;
  }

  public Tensor shape(List<Long> shape) {
    this.shape = shape;
    return this;
  }

  public void setShape(List<Long> shape) {
    this.shape = shape;
  }

  /** Base64 with padding in JSON; &#x60;bin&#x60; in MessagePack. */
  public String getData() {
    return data;
  }

  public Tensor data(String data) {
    this.data = data;
    return this;
  }

  public void setData(String data) {
    this.data = data;
  }

  public static Tensor fromJson(String text) {
    return JSON.getGson().fromJson(text, Tensor.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
