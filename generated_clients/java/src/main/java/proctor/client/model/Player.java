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

/** Who plays, by its own words; for the profile &#x60;attribution&#x60;. */
public class Player {
  @SerializedName("name")
  @javax.annotation.Nonnull
  private String name;

  @SerializedName("version")
  private String version;

  @SerializedName("client")
  private String client;

  /** Of the policy, as in &#x60;policy&#x60; of the run. */
  public String getName() {
    return name;
  }

  public Player name(String name) {
    this.name = name;
    return this;
  }

  public void setName(String name) {
    this.name = name;
  }

  /** Of the policy. */
  public String getVersion() {
    return version;
  }

  public Player version(String version) {
    this.version = version;
    return this;
  }

  public void setVersion(String version) {
    this.version = version;
  }

  /** The program that attaches and its version. */
  public String getClient() {
    return client;
  }

  public Player client(String client) {
    this.client = client;
    return this;
  }

  public void setClient(String client) {
    this.client = client;
  }

  public static Player fromJson(String text) {
    return JSON.getGson().fromJson(text, Player.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
