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

/** The &#x60;player&#x60; of an &#x60;attach_worker&#x60;. */
public class PlayerView {
  @SerializedName("name")
  @javax.annotation.Nonnull
  private String name;

  @SerializedName("version")
  private String version;

  @SerializedName("client")
  private String client;

  public String getName() {
    return name;
  }

  public PlayerView name(String name) {
    this.name = name;
    return this;
  }

  public void setName(String name) {
    this.name = name;
  }

  public String getVersion() {
    return version;
  }

  public PlayerView version(String version) {
    this.version = version;
    return this;
  }

  public void setVersion(String version) {
    this.version = version;
  }

  public String getClient() {
    return client;
  }

  public PlayerView client(String client) {
    this.client = client;
    return this;
  }

  public void setClient(String client) {
    this.client = client;
  }

  public static PlayerView fromJson(String text) {
    return JSON.getGson().fromJson(text, PlayerView.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
