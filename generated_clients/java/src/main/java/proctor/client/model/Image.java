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

/** RGB or grey, row 0 on top; raw is height × width × channels bytes. */
public class Image {
  @SerializedName("codec")
  @javax.annotation.Nonnull
  private String codec;

  @SerializedName("width")
  @javax.annotation.Nonnull
  private Integer width;

  @SerializedName("height")
  @javax.annotation.Nonnull
  private Integer height;

  @SerializedName("channels")
  @javax.annotation.Nonnull
  private Integer channels;

  @SerializedName("data")
  @javax.annotation.Nonnull
  private String data;

  public String getCodec() {
    return codec;
  }

  public Image codec(String codec) {
    this.codec = codec;
    return this;
  }

  public void setCodec(String codec) {
    this.codec = codec;
  }

  public Integer getWidth() {
    return width;
  }

  public Image width(Integer width) {
    this.width = width;
    return this;
  }

  public void setWidth(Integer width) {
    this.width = width;
  }

  public Integer getHeight() {
    return height;
  }

  public Image height(Integer height) {
    this.height = height;
    return this;
  }

  public void setHeight(Integer height) {
    this.height = height;
  }

  public Integer getChannels() {
    return channels;
  }

  public Image channels(Integer channels) {
    this.channels = channels;
    return this;
  }

  public void setChannels(Integer channels) {
    this.channels = channels;
  }

  /** Base64 with padding in JSON; &#x60;bin&#x60; in MessagePack. */
  public String getData() {
    return data;
  }

  public Image data(String data) {
    this.data = data;
    return this;
  }

  public void setData(String data) {
    this.data = data;
  }

  public static Image fromJson(String text) {
    return JSON.getGson().fromJson(text, Image.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
