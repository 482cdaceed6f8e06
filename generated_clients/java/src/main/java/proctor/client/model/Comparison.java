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
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import proctor.client.model.ComparedRun;

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
 * See scoring.md for every number here.
 */
@javax.annotation.Generated(value = "org.openapitools.codegen.languages.JavaClientCodegen", comments = "Generator version: 7.26.0")
public class Comparison {
  public static final String SERIALIZED_NAME_BASELINE = "baseline";
  @SerializedName(SERIALIZED_NAME_BASELINE)
  @javax.annotation.Nonnull
  private String baseline;

  public static final String SERIALIZED_NAME_BENCHMARK_ID = "benchmark_id";
  @SerializedName(SERIALIZED_NAME_BENCHMARK_ID)
  @javax.annotation.Nonnull
  private String benchmarkId;

  public static final String SERIALIZED_NAME_MANIFEST_SHA256 = "manifest_sha256";
  @SerializedName(SERIALIZED_NAME_MANIFEST_SHA256)
  @javax.annotation.Nonnull
  private String manifestSha256;

  public static final String SERIALIZED_NAME_TOLERANCE = "tolerance";
  @SerializedName(SERIALIZED_NAME_TOLERANCE)
  @javax.annotation.Nonnull
  private Double tolerance;

  public static final String SERIALIZED_NAME_RUNS = "runs";
  @SerializedName(SERIALIZED_NAME_RUNS)
  @javax.annotation.Nonnull
  private List<ComparedRun> runs;

  public Comparison() {
  }

  public Comparison baseline(@javax.annotation.Nonnull String baseline) {
    this.baseline = baseline;
    return this;
  }

  /**
   * Id of the run that the others are compared with.
   * @return baseline
   */
  @javax.annotation.Nonnull
  public String getBaseline() {
    return baseline;
  }

  public void setBaseline(@javax.annotation.Nonnull String baseline) {
    this.baseline = baseline;
  }


  public Comparison benchmarkId(@javax.annotation.Nonnull String benchmarkId) {
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


  public Comparison manifestSha256(@javax.annotation.Nonnull String manifestSha256) {
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


  public Comparison tolerance(@javax.annotation.Nonnull Double tolerance) {
    this.tolerance = tolerance;
    return this;
  }

  /**
   * Get tolerance
   * minimum: 0
   * maximum: 1
   * @return tolerance
   */
  @javax.annotation.Nonnull
  public Double getTolerance() {
    return tolerance;
  }

  public void setTolerance(@javax.annotation.Nonnull Double tolerance) {
    this.tolerance = tolerance;
  }


  public Comparison runs(@javax.annotation.Nonnull List<ComparedRun> runs) {
    this.runs = runs;
    return this;
  }

  public Comparison addRunsItem(ComparedRun runsItem) {
    if (this.runs == null) {
      this.runs = new ArrayList<>();
    }
    this.runs.add(runsItem);
    return this;
  }

  /**
   * One entry per run that was named, in that order.
   * @return runs
   */
  @javax.annotation.Nonnull
  public List<ComparedRun> getRuns() {
    return runs;
  }

  public void setRuns(@javax.annotation.Nonnull List<ComparedRun> runs) {
    this.runs = runs;
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
   * @return the Comparison instance itself
   */
  public Comparison putAdditionalProperty(String key, Object value) {
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
    Comparison comparison = (Comparison) o;
    return Objects.equals(this.baseline, comparison.baseline) &&
        Objects.equals(this.benchmarkId, comparison.benchmarkId) &&
        Objects.equals(this.manifestSha256, comparison.manifestSha256) &&
        Objects.equals(this.tolerance, comparison.tolerance) &&
        Objects.equals(this.runs, comparison.runs)&&
        Objects.equals(this.additionalProperties, comparison.additionalProperties);
  }

  @Override
  public int hashCode() {
    return Objects.hash(baseline, benchmarkId, manifestSha256, tolerance, runs, additionalProperties);
  }

  @Override
  public String toString() {
    StringBuilder sb = new StringBuilder();
    sb.append("class Comparison {\n");
    sb.append("    baseline: ").append(toIndentedString(baseline)).append("\n");
    sb.append("    benchmarkId: ").append(toIndentedString(benchmarkId)).append("\n");
    sb.append("    manifestSha256: ").append(toIndentedString(manifestSha256)).append("\n");
    sb.append("    tolerance: ").append(toIndentedString(tolerance)).append("\n");
    sb.append("    runs: ").append(toIndentedString(runs)).append("\n");
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
    openapiFields = new HashSet<String>(Arrays.asList("baseline", "benchmark_id", "manifest_sha256", "tolerance", "runs"));

    // a set of required properties/fields (JSON key names)
    openapiRequiredFields = new HashSet<String>(Arrays.asList("baseline", "benchmark_id", "manifest_sha256", "tolerance", "runs"));
  }

  /**
   * Validates the JSON Element and throws an exception if issues found
   *
   * @param jsonElement JSON Element
   * @throws IOException if the JSON Element is invalid with respect to Comparison
   */
  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
      if (jsonElement == null) {
        if (!Comparison.openapiRequiredFields.isEmpty()) { // has required fields but JSON element is null
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field(s) %s in Comparison is not found in the empty JSON string", Comparison.openapiRequiredFields.toString()));
        }
      }

      // check to make sure all required properties/fields are present in the JSON string
      for (String requiredField : Comparison.openapiRequiredFields) {
        if (jsonElement.getAsJsonObject().get(requiredField) == null) {
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field `%s` is not found in the JSON string: %s", requiredField, jsonElement.toString()));
        }
      }
        JsonObject jsonObj = jsonElement.getAsJsonObject();
      if (!jsonObj.get("baseline").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `baseline` to be a primitive type in the JSON string but got `%s`", jsonObj.get("baseline").toString()));
      }
      if (!jsonObj.get("benchmark_id").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `benchmark_id` to be a primitive type in the JSON string but got `%s`", jsonObj.get("benchmark_id").toString()));
      }
      if (!jsonObj.get("manifest_sha256").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `manifest_sha256` to be a primitive type in the JSON string but got `%s`", jsonObj.get("manifest_sha256").toString()));
      }
      // ensure the required json array is present
      if (jsonObj.get("runs") == null) {
        throw new IllegalArgumentException("Expected the field `linkedContent` to be an array in the JSON string but got `null`");
      } else if (!jsonObj.get("runs").isJsonArray()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `runs` to be an array in the JSON string but got `%s`", jsonObj.get("runs").toString()));
      }
  }

  public static class CustomTypeAdapterFactory implements TypeAdapterFactory {
    @SuppressWarnings("unchecked")
    @Override
    public <T> TypeAdapter<T> create(Gson gson, TypeToken<T> type) {
       if (!Comparison.class.isAssignableFrom(type.getRawType())) {
         return null; // this class only serializes 'Comparison' and its subtypes
       }
       final TypeAdapter<JsonElement> elementAdapter = gson.getAdapter(JsonElement.class);
       final TypeAdapter<Comparison> thisAdapter
                        = gson.getDelegateAdapter(this, TypeToken.get(Comparison.class));

       return (TypeAdapter<T>) new TypeAdapter<Comparison>() {
           @Override
           public void write(JsonWriter out, Comparison value) throws IOException {
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
           public Comparison read(JsonReader in) throws IOException {
             JsonElement jsonElement = elementAdapter.read(in);
             validateJsonElement(jsonElement);
             JsonObject jsonObj = jsonElement.getAsJsonObject();
             // store additional fields in the deserialized instance
             Comparison instance = thisAdapter.fromJsonTree(jsonObj);
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
   * Create an instance of Comparison given an JSON string
   *
   * @param jsonString JSON string
   * @return An instance of Comparison
   * @throws IOException if the JSON string is invalid with respect to Comparison
   */
  public static Comparison fromJson(String jsonString) throws IOException {
    return JSON.getGson().fromJson(jsonString, Comparison.class);
  }

  /**
   * Convert an instance of Comparison to an JSON string
   *
   * @return JSON string
   */
  public String toJson() {
    return JSON.getGson().toJson(this);
  }
}
