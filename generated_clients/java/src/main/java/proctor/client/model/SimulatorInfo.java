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

public class SimulatorInfo {
  @SerializedName("name")
  @javax.annotation.Nonnull
  private String name;

  @SerializedName("version")
  @javax.annotation.Nonnull
  private String version;

  @SerializedName("quality")
  private String quality;

  public String getName() {
    return name;
  }

  public SimulatorInfo name(String name) {
    this.name = name;
    return this;
  }

  public void setName(String name) {
    this.name = name;
  }

  public String getVersion() {
    return version;
  }

  public SimulatorInfo version(String version) {
    this.version = version;
    return this;
  }

  public void setVersion(String version) {
    this.version = version;
  }

  /** Named rendering quality, where there is one. */
  public String getQuality() {
    return quality;
  }

  public SimulatorInfo quality(String quality) {
    this.quality = quality;
    return this;
  }

  public void setQuality(String quality) {
    this.quality = quality;
  }

  public static SimulatorInfo fromJson(String text) {
    return JSON.getGson().fromJson(text, SimulatorInfo.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
