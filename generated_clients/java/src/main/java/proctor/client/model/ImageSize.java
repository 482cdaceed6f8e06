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

public class ImageSize {
  @SerializedName("width")
  @javax.annotation.Nonnull
  private Integer width;

  @SerializedName("height")
  @javax.annotation.Nonnull
  private Integer height;

  public Integer getWidth() {
    return width;
  }

  public ImageSize width(Integer width) {
    this.width = width;
    return this;
  }

  public void setWidth(Integer width) {
    this.width = width;
  }

  public Integer getHeight() {
    return height;
  }

  public ImageSize height(Integer height) {
    this.height = height;
    return this;
  }

  public void setHeight(Integer height) {
    this.height = height;
  }

  public static ImageSize fromJson(String text) {
    return JSON.getGson().fromJson(text, ImageSize.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
