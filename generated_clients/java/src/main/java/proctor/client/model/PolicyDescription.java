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

/** What a policy server says of itself; see policy.yaml. */
public class PolicyDescription {
  @SerializedName("name")
  @javax.annotation.Nonnull
  private String name;

  @SerializedName("version")
  private String version;

  @SerializedName("protocol")
  @javax.annotation.Nonnull
  private ProtocolRange protocol;

  @SerializedName("max_sessions")
  @javax.annotation.Nonnull
  private Integer maxSessions;

  @SerializedName("assumes")
  private Assumptions assumes;

  public String getName() {
    return name;
  }

  public PolicyDescription name(String name) {
    this.name = name;
    return this;
  }

  public void setName(String name) {
    this.name = name;
  }

  public String getVersion() {
    return version;
  }

  public PolicyDescription version(String version) {
    this.version = version;
    return this;
  }

  public void setVersion(String version) {
    this.version = version;
  }

  public ProtocolRange getProtocol() {
    return protocol;
  }

  public PolicyDescription protocol(ProtocolRange protocol) {
    this.protocol = protocol;
    return this;
  }

  public void setProtocol(ProtocolRange protocol) {
    this.protocol = protocol;
  }

  /** Most episodes that it plays at a time. */
  public Integer getMaxSessions() {
    return maxSessions;
  }

  public PolicyDescription maxSessions(Integer maxSessions) {
    this.maxSessions = maxSessions;
    return this;
  }

  public void setMaxSessions(Integer maxSessions) {
    this.maxSessions = maxSessions;
  }

  public Assumptions getAssumes() {
    return assumes;
  }

  public PolicyDescription assumes(Assumptions assumes) {
    this.assumes = assumes;
    return this;
  }

  public void setAssumes(Assumptions assumes) {
    this.assumes = assumes;
  }

  public static PolicyDescription fromJson(String text) {
    return JSON.getGson().fromJson(text, PolicyDescription.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
