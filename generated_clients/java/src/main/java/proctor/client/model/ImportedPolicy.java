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

public class ImportedPolicy {
  @SerializedName("name")
  @javax.annotation.Nonnull
  private String name;

  @SerializedName("version")
  private String version;

  public String getName() {
    return name;
  }

  public ImportedPolicy name(String name) {
    this.name = name;
    return this;
  }

  public void setName(String name) {
    this.name = name;
  }

  public String getVersion() {
    return version;
  }

  public ImportedPolicy version(String version) {
    this.version = version;
    return this;
  }

  public void setVersion(String version) {
    this.version = version;
  }

  public static ImportedPolicy fromJson(String text) {
    return JSON.getGson().fromJson(text, ImportedPolicy.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
