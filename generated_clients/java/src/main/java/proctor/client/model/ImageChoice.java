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

/** Recorded with the result, because it changes the score. */
public class ImageChoice {
  @SerializedName("codec")
  @javax.annotation.Nonnull
  private String codec;

  @SerializedName("width")
  @javax.annotation.Nonnull
  private Integer width;

  @SerializedName("height")
  @javax.annotation.Nonnull
  private Integer height;

  public String getCodec() {
    return codec;
  }

  public ImageChoice codec(String codec) {
    this.codec = codec;
    return this;
  }

  public void setCodec(String codec) {
    this.codec = codec;
  }

  public Integer getWidth() {
    return width;
  }

  public ImageChoice width(Integer width) {
    this.width = width;
    return this;
  }

  public void setWidth(Integer width) {
    this.width = width;
  }

  public Integer getHeight() {
    return height;
  }

  public ImageChoice height(Integer height) {
    this.height = height;
    return this;
  }

  public void setHeight(Integer height) {
    this.height = height;
  }

  public static ImageChoice fromJson(String text) {
    return JSON.getGson().fromJson(text, ImageChoice.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
