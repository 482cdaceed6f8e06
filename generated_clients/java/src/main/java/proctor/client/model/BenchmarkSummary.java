/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


package proctor.client.model;

import java.util.Objects;
import com.google.gson.TypeAdapter;
import com.google.gson.annotations.JsonAdapter;
import com.google.gson.annotations.SerializedName;
import com.google.gson.stream.JsonReader;
import com.google.gson.stream.JsonWriter;
import java.io.IOException;
import java.util.Arrays;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonDeserializationContext;
import com.google.gson.JsonDeserializer;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonNull;
import com.google.gson.JsonParseException;
import com.google.gson.TypeAdapterFactory;
import com.google.gson.reflect.TypeToken;
import com.google.gson.TypeAdapter;
import com.google.gson.stream.JsonReader;
import com.google.gson.stream.JsonWriter;
import java.io.IOException;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

import proctor.client.JSON;

/**
 * BenchmarkSummary
 */
@javax.annotation.Generated(value = "org.openapitools.codegen.languages.JavaClientCodegen", comments = "Generator version: 7.26.0")
public class BenchmarkSummary {
  public static final String SERIALIZED_NAME_BENCHMARK_ID = "benchmark_id";
  @SerializedName(SERIALIZED_NAME_BENCHMARK_ID)
  @javax.annotation.Nonnull
  private String benchmarkId;

  public static final String SERIALIZED_NAME_VERSION = "version";
  @SerializedName(SERIALIZED_NAME_VERSION)
  @javax.annotation.Nonnull
  private String version;

  public static final String SERIALIZED_NAME_TITLE = "title";
  @SerializedName(SERIALIZED_NAME_TITLE)
  @javax.annotation.Nonnull
  private String title;

  public static final String SERIALIZED_NAME_MANIFEST_SHA256 = "manifest_sha256";
  @SerializedName(SERIALIZED_NAME_MANIFEST_SHA256)
  @javax.annotation.Nonnull
  private String manifestSha256;

  public static final String SERIALIZED_NAME_EPISODES_TOTAL = "episodes_total";
  @SerializedName(SERIALIZED_NAME_EPISODES_TOTAL)
  @javax.annotation.Nonnull
  private Integer episodesTotal;

  public BenchmarkSummary() {
  }

  public BenchmarkSummary benchmarkId(@javax.annotation.Nonnull String benchmarkId) {
    this.benchmarkId = benchmarkId;
    return this;
  }

  /**
   * Get benchmarkId
   * @return benchmarkId
   */
  @javax.annotation.Nonnull
  public String getBenchmarkId() {
    return benchmarkId;
  }

  public void setBenchmarkId(@javax.annotation.Nonnull String benchmarkId) {
    this.benchmarkId = benchmarkId;
  }


  public BenchmarkSummary version(@javax.annotation.Nonnull String version) {
    this.version = version;
    return this;
  }

  /**
   * Get version
   * @return version
   */
  @javax.annotation.Nonnull
  public String getVersion() {
    return version;
  }

  public void setVersion(@javax.annotation.Nonnull String version) {
    this.version = version;
  }


  public BenchmarkSummary title(@javax.annotation.Nonnull String title) {
    this.title = title;
    return this;
  }

  /**
   * Get title
   * @return title
   */
  @javax.annotation.Nonnull
  public String getTitle() {
    return title;
  }

  public void setTitle(@javax.annotation.Nonnull String title) {
    this.title = title;
  }


  public BenchmarkSummary manifestSha256(@javax.annotation.Nonnull String manifestSha256) {
    this.manifestSha256 = manifestSha256;
    return this;
  }

  /**
   * The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
   * @return manifestSha256
   */
  @javax.annotation.Nonnull
  public String getManifestSha256() {
    return manifestSha256;
  }

  public void setManifestSha256(@javax.annotation.Nonnull String manifestSha256) {
    this.manifestSha256 = manifestSha256;
  }


  public BenchmarkSummary episodesTotal(@javax.annotation.Nonnull Integer episodesTotal) {
    this.episodesTotal = episodesTotal;
    return this;
  }

  /**
   * Get episodesTotal
   * minimum: 1
   * @return episodesTotal
   */
  @javax.annotation.Nonnull
  public Integer getEpisodesTotal() {
    return episodesTotal;
  }

  public void setEpisodesTotal(@javax.annotation.Nonnull Integer episodesTotal) {
    this.episodesTotal = episodesTotal;
  }

  /**
   * A container for additional, undeclared properties.
   * This is a holder for any undeclared properties as specified with
   * the 'additionalProperties' keyword in the OAS document.
   */
  private Map<String, Object> additionalProperties;

  /**
   * Set the additional (undeclared) property with the specified name and value.
   * If the property does not already exist, create it otherwise replace it.
   *
   * @param key name of the property
   * @param value value of the property
   * @return the BenchmarkSummary instance itself
   */
  public BenchmarkSummary putAdditionalProperty(String key, Object value) {
    if (this.additionalProperties == null) {
        this.additionalProperties = new HashMap<String, Object>();
    }
    this.additionalProperties.put(key, value);
    return this;
  }

  /**
   * Return the additional (undeclared) property.
   *
   * @return a map of objects
   */
  public Map<String, Object> getAdditionalProperties() {
    return additionalProperties;
  }

  /**
   * Return the additional (undeclared) property with the specified name.
   *
   * @param key name of the property
   * @return an object
   */
  public Object getAdditionalProperty(String key) {
    if (this.additionalProperties == null) {
        return null;
    }
    return this.additionalProperties.get(key);
  }


  @Override
  public boolean equals(Object o) {
    if (this == o) {
      return true;
    }
    if (o == null || getClass() != o.getClass()) {
      return false;
    }
    BenchmarkSummary benchmarkSummary = (BenchmarkSummary) o;
    return Objects.equals(this.benchmarkId, benchmarkSummary.benchmarkId) &&
        Objects.equals(this.version, benchmarkSummary.version) &&
        Objects.equals(this.title, benchmarkSummary.title) &&
        Objects.equals(this.manifestSha256, benchmarkSummary.manifestSha256) &&
        Objects.equals(this.episodesTotal, benchmarkSummary.episodesTotal)&&
        Objects.equals(this.additionalProperties, benchmarkSummary.additionalProperties);
  }

  @Override
  public int hashCode() {
    return Objects.hash(benchmarkId, version, title, manifestSha256, episodesTotal, additionalProperties);
  }

  @Override
  public String toString() {
    StringBuilder sb = new StringBuilder();
    sb.append("class BenchmarkSummary {\n");
    sb.append("    benchmarkId: ").append(toIndentedString(benchmarkId)).append("\n");
    sb.append("    version: ").append(toIndentedString(version)).append("\n");
    sb.append("    title: ").append(toIndentedString(title)).append("\n");
    sb.append("    manifestSha256: ").append(toIndentedString(manifestSha256)).append("\n");
    sb.append("    episodesTotal: ").append(toIndentedString(episodesTotal)).append("\n");
    sb.append("    additionalProperties: ").append(toIndentedString(additionalProperties)).append("\n");
    sb.append("}");
    return sb.toString();
  }

  /**
   * Convert the given object to string with each line indented by 4 spaces
   * (except the first line).
   */
  private String toIndentedString(Object o) {
    return o == null ? "null" : o.toString().replace("\n", "\n    ");
  }


  public static HashSet<String> openapiFields;
  public static HashSet<String> openapiRequiredFields;

  static {
    // a set of all properties/fields (JSON key names)
    openapiFields = new HashSet<String>(Arrays.asList("benchmark_id", "version", "title", "manifest_sha256", "episodes_total"));

    // a set of required properties/fields (JSON key names)
    openapiRequiredFields = new HashSet<String>(Arrays.asList("benchmark_id", "version", "title", "manifest_sha256", "episodes_total"));
  }

  /**
   * Validates the JSON Element and throws an exception if issues found
   *
   * @param jsonElement JSON Element
   * @throws IOException if the JSON Element is invalid with respect to BenchmarkSummary
   */
  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
      if (jsonElement == null) {
        if (!BenchmarkSummary.openapiRequiredFields.isEmpty()) { // has required fields but JSON element is null
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field(s) %s in BenchmarkSummary is not found in the empty JSON string", BenchmarkSummary.openapiRequiredFields.toString()));
        }
      }

      // check to make sure all required properties/fields are present in the JSON string
      for (String requiredField : BenchmarkSummary.openapiRequiredFields) {
        if (jsonElement.getAsJsonObject().get(requiredField) == null) {
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field `%s` is not found in the JSON string: %s", requiredField, jsonElement.toString()));
        }
      }
        JsonObject jsonObj = jsonElement.getAsJsonObject();
      if (!jsonObj.get("benchmark_id").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `benchmark_id` to be a primitive type in the JSON string but got `%s`", jsonObj.get("benchmark_id").toString()));
      }
      if (!jsonObj.get("version").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `version` to be a primitive type in the JSON string but got `%s`", jsonObj.get("version").toString()));
      }
      if (!jsonObj.get("title").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `title` to be a primitive type in the JSON string but got `%s`", jsonObj.get("title").toString()));
      }
      if (!jsonObj.get("manifest_sha256").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `manifest_sha256` to be a primitive type in the JSON string but got `%s`", jsonObj.get("manifest_sha256").toString()));
      }
  }

  public static class CustomTypeAdapterFactory implements TypeAdapterFactory {
    @SuppressWarnings("unchecked")
    @Override
    public <T> TypeAdapter<T> create(Gson gson, TypeToken<T> type) {
       if (!BenchmarkSummary.class.isAssignableFrom(type.getRawType())) {
         return null; // this class only serializes 'BenchmarkSummary' and its subtypes
       }
       final TypeAdapter<JsonElement> elementAdapter = gson.getAdapter(JsonElement.class);
       final TypeAdapter<BenchmarkSummary> thisAdapter
                        = gson.getDelegateAdapter(this, TypeToken.get(BenchmarkSummary.class));

       return (TypeAdapter<T>) new TypeAdapter<BenchmarkSummary>() {
           @Override
           public void write(JsonWriter out, BenchmarkSummary value) throws IOException {
             JsonObject obj = thisAdapter.toJsonTree(value).getAsJsonObject();
             obj.remove("additionalProperties");
             // serialize additional properties
             if (value.getAdditionalProperties() != null) {
               for (Map.Entry<String, Object> entry : value.getAdditionalProperties().entrySet()) {
                 if (entry.getValue() instanceof String)
                   obj.addProperty(entry.getKey(), (String) entry.getValue());
                 else if (entry.getValue() instanceof Number)
                   obj.addProperty(entry.getKey(), (Number) entry.getValue());
                 else if (entry.getValue() instanceof Boolean)
                   obj.addProperty(entry.getKey(), (Boolean) entry.getValue());
                 else if (entry.getValue() instanceof Character)
                   obj.addProperty(entry.getKey(), (Character) entry.getValue());
                 else {
                   JsonElement jsonElement = gson.toJsonTree(entry.getValue());
                   if (jsonElement.isJsonNull()) {
                     obj.add(entry.getKey(), JsonNull.INSTANCE);
                   } else if (jsonElement.isJsonArray()) {
                     obj.add(entry.getKey(), jsonElement.getAsJsonArray());
                   } else {
                     obj.add(entry.getKey(), jsonElement.getAsJsonObject());
                   }
                 }
               }
             }
             elementAdapter.write(out, obj);
           }

           @Override
           public BenchmarkSummary read(JsonReader in) throws IOException {
             JsonElement jsonElement = elementAdapter.read(in);
             validateJsonElement(jsonElement);
             JsonObject jsonObj = jsonElement.getAsJsonObject();
             // store additional fields in the deserialized instance
             BenchmarkSummary instance = thisAdapter.fromJsonTree(jsonObj);
             for (Map.Entry<String, JsonElement> entry : jsonObj.entrySet()) {
               if (!openapiFields.contains(entry.getKey())) {
                 if (entry.getValue().isJsonPrimitive()) { // primitive type
                   if (entry.getValue().getAsJsonPrimitive().isString())
                     instance.putAdditionalProperty(entry.getKey(), entry.getValue().getAsString());
                   else if (entry.getValue().getAsJsonPrimitive().isNumber())
                     instance.putAdditionalProperty(entry.getKey(), entry.getValue().getAsNumber());
                   else if (entry.getValue().getAsJsonPrimitive().isBoolean())
                     instance.putAdditionalProperty(entry.getKey(), entry.getValue().getAsBoolean());
                   else
                     throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The field `%s` has unknown primitive type. Value: %s", entry.getKey(), entry.getValue().toString()));
                 } else if (entry.getValue().isJsonArray()) {
                     instance.putAdditionalProperty(entry.getKey(), gson.fromJson(entry.getValue(), List.class));
                 } else { // JSON object
                     instance.putAdditionalProperty(entry.getKey(), gson.fromJson(entry.getValue(), HashMap.class));
                 }
               }
             }
             return instance;
           }

       }.nullSafe();
    }
  }

  /**
   * Create an instance of BenchmarkSummary given an JSON string
   *
   * @param jsonString JSON string
   * @return An instance of BenchmarkSummary
   * @throws IOException if the JSON string is invalid with respect to BenchmarkSummary
   */
  public static BenchmarkSummary fromJson(String jsonString) throws IOException {
    return JSON.getGson().fromJson(jsonString, BenchmarkSummary.class);
  }

  /**
   * Convert an instance of BenchmarkSummary to an JSON string
   *
   * @return JSON string
   */
  public String toJson() {
    return JSON.getGson().toJson(this);
  }
}
