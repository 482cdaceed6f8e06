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

public class PolicyInfo {
  @SerializedName("name")
  @javax.annotation.Nonnull
  private String name;

  @SerializedName("version")
  private String version;

  @SerializedName("submitter")
  private String submitter;

  @SerializedName("homepage")
  private String homepage;

  public String getName() {
    return name;
  }

  public PolicyInfo name(String name) {
    this.name = name;
    return this;
  }

  public void setName(String name) {
    this.name = name;
  }

  public String getVersion() {
    return version;
  }

  public PolicyInfo version(String version) {
    this.version = version;
    return this;
  }

  public void setVersion(String version) {
    this.version = version;
  }

  public String getSubmitter() {
    return submitter;
  }

  public PolicyInfo submitter(String submitter) {
    this.submitter = submitter;
    return this;
  }

  public void setSubmitter(String submitter) {
    this.submitter = submitter;
  }

  public String getHomepage() {
    return homepage;
  }

  public PolicyInfo homepage(String homepage) {
    this.homepage = homepage;
    return this;
  }

  public void setHomepage(String homepage) {
    this.homepage = homepage;
  }

  public static PolicyInfo fromJson(String text) {
    return JSON.getGson().fromJson(text, PolicyInfo.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
