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

/** What an entry says of itself; a member that is absent is not shown. */
public class PublishEntry {
  @SerializedName("model_name")
  @javax.annotation.Nonnull
  private String modelName;

  @SerializedName("is_public")
  @javax.annotation.Nonnull
  private Boolean isPublic;

  @SerializedName("model_type")
  private String modelType;

  @SerializedName("organisation")
  private String organisation;

  @SerializedName("homepage")
  private String homepage;

  @SerializedName("code_url")
  private String codeUrl;

  @SerializedName("notes")
  private String notes;

  public String getModelName() {
    return modelName;
  }

  public PublishEntry modelName(String modelName) {
    this.modelName = modelName;
    return this;
  }

  public void setModelName(String modelName) {
    this.modelName = modelName;
  }

  /** Whether others see the entry, and whether it has a rank. */
  public Boolean getIsPublic() {
    return isPublic;
  }

  public PublishEntry isPublic(Boolean isPublic) {
    this.isPublic = isPublic;
    return this;
  }

  public void setIsPublic(Boolean isPublic) {
    this.isPublic = isPublic;
  }

  /** What kind of model it is, for example &#x60;VLA&#x60; or &#x60;diffusion policy&#x60;. */
  public String getModelType() {
    return modelType;
  }

  public PublishEntry modelType(String modelType) {
    this.modelType = modelType;
    return this;
  }

  public void setModelType(String modelType) {
    this.modelType = modelType;
  }

  public String getOrganisation() {
    return organisation;
  }

  public PublishEntry organisation(String organisation) {
    this.organisation = organisation;
    return this;
  }

  public void setOrganisation(String organisation) {
    this.organisation = organisation;
  }

  public String getHomepage() {
    return homepage;
  }

  public PublishEntry homepage(String homepage) {
    this.homepage = homepage;
    return this;
  }

  public void setHomepage(String homepage) {
    this.homepage = homepage;
  }

  public String getCodeUrl() {
    return codeUrl;
  }

  public PublishEntry codeUrl(String codeUrl) {
    this.codeUrl = codeUrl;
    return this;
  }

  public void setCodeUrl(String codeUrl) {
    this.codeUrl = codeUrl;
  }

  public String getNotes() {
    return notes;
  }

  public PublishEntry notes(String notes) {
    this.notes = notes;
    return this;
  }

  public void setNotes(String notes) {
    this.notes = notes;
  }

  public static PublishEntry fromJson(String text) {
    return JSON.getGson().fromJson(text, PublishEntry.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
