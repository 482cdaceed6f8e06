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

/** What a server says of itself before anyone authenticates. */
public class Service {
  @SerializedName("name")
  @javax.annotation.Nonnull
  private String name;

  @SerializedName("version")
  @javax.annotation.Nonnull
  private String version;

  @SerializedName("protocol")
  @javax.annotation.Nonnull
  private ProtocolRange protocol;

  @SerializedName("profiles")
  @javax.annotation.Nonnull
  private List<String> profiles;

  @SerializedName("limits")
  @javax.annotation.Nonnull
  private Limits limits;

  @SerializedName("encodings")
  @javax.annotation.Nonnull
  private List<String> encodings;

  @SerializedName("image_codecs")
  @javax.annotation.Nonnull
  private List<String> imageCodecs;

  @SerializedName("server_time")
  @javax.annotation.Nonnull
  private OffsetDateTime serverTime;

  public String getName() {
    return name;
  }

  public Service name(String name) {
    this.name = name;
    return this;
  }

  public void setName(String name) {
    this.name = name;
  }

  /** Version of the server software. */
  public String getVersion() {
    return version;
  }

  public Service version(String version) {
    this.version = version;
    return this;
  }

  public void setVersion(String version) {
    this.version = version;
  }

  public ProtocolRange getProtocol() {
    return protocol;
  }

  public Service protocol(ProtocolRange protocol) {
    this.protocol = protocol;
    return this;
  }

  public void setProtocol(ProtocolRange protocol) {
    this.protocol = protocol;
  }

  /** Parts of the protocol offered; &#x60;core&#x60; may be left out, for it always is. An operation with &#x60;x-profile&#x60; is there when its profile is announced. The rules of the profile &#x60;crash&#x60; are not announced. The kit judges them where it may kill and restart the server; a server whose runs do not outlive its process is certified without them and without EVT-009, PUSH-017, REC-123 and REC-124, and its report says that they were not verified. Those of the profile &#x60;cluster&#x60; are not announced, either. They bind a service that is reached at several base URLs, and the kit judges them where it is given all of these. */
  public List<String> getProfiles() {
    return profiles;
  }

  public Service profiles(List<String> profiles) {
    this.profiles = profiles;
    return this;
  }

  public void setProfiles(List<String> profiles) {
    this.profiles = profiles;
  }

  public Limits getLimits() {
    return limits;
  }

  public Service limits(Limits limits) {
    this.limits = limits;
    return this;
  }

  public void setLimits(Limits limits) {
    this.limits = limits;
  }

  /** Media types of the data plane. */
  public List<String> getEncodings() {
    return encodings;
  }

  public Service encodings(List<String> encodings) {
    this.encodings = encodings;
    return this;
  }

  public void setEncodings(List<String> encodings) {
    this.encodings = encodings;
  }

  public List<String> getImageCodecs() {
    return imageCodecs;
  }

  public Service imageCodecs(List<String> imageCodecs) {
    this.imageCodecs = imageCodecs;
    return this;
  }

  public void setImageCodecs(List<String> imageCodecs) {
    this.imageCodecs = imageCodecs;
  }

  /** The server&#39;s clock, UTC. */
  public OffsetDateTime getServerTime() {
    return serverTime;
  }

  public Service serverTime(OffsetDateTime serverTime) {
    this.serverTime = serverTime;
    return this;
  }

  public void setServerTime(OffsetDateTime serverTime) {
    this.serverTime = serverTime;
  }

  public static Service fromJson(String text) {
    return JSON.getGson().fromJson(text, Service.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
