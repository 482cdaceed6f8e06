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
import proctor.client.model.CalibrationOptions;
import proctor.client.model.ImageChoice;
import proctor.client.model.PolicyInfo;
import proctor.client.model.PolicyServer;
import proctor.client.model.RunMode;

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
 * SubmitRun
 */
@javax.annotation.Generated(value = "org.openapitools.codegen.languages.JavaClientCodegen", comments = "Generator version: 7.26.0")
public class SubmitRun {
  public static final String SERIALIZED_NAME_BENCHMARK_ID = "benchmark_id";
  @SerializedName(SERIALIZED_NAME_BENCHMARK_ID)
  @javax.annotation.Nonnull
  private String benchmarkId;

  public static final String SERIALIZED_NAME_POLICY = "policy";
  @SerializedName(SERIALIZED_NAME_POLICY)
  @javax.annotation.Nonnull
  private PolicyInfo policy;

  public static final String SERIALIZED_NAME_MAX_WORKERS = "max_workers";
  @SerializedName(SERIALIZED_NAME_MAX_WORKERS)
  @javax.annotation.Nullable
  private Integer maxWorkers;

  public static final String SERIALIZED_NAME_IDLE_TIMEOUT_S = "idle_timeout_s";
  @SerializedName(SERIALIZED_NAME_IDLE_TIMEOUT_S)
  @javax.annotation.Nullable
  private Double idleTimeoutS;

  public static final String SERIALIZED_NAME_IMAGES = "images";
  @SerializedName(SERIALIZED_NAME_IMAGES)
  @javax.annotation.Nullable
  private ImageChoice images;

  public static final String SERIALIZED_NAME_OPTIONS = "options";
  @SerializedName(SERIALIZED_NAME_OPTIONS)
  @javax.annotation.Nullable
  private CalibrationOptions options;

  public static final String SERIALIZED_NAME_MODE = "mode";
  @SerializedName(SERIALIZED_NAME_MODE)
  @javax.annotation.Nullable
  private RunMode mode;

  public static final String SERIALIZED_NAME_POLICY_SERVER = "policy_server";
  @SerializedName(SERIALIZED_NAME_POLICY_SERVER)
  @javax.annotation.Nullable
  private PolicyServer policyServer;

  public SubmitRun() {
  }

  public SubmitRun benchmarkId(@javax.annotation.Nonnull String benchmarkId) {
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


  public SubmitRun policy(@javax.annotation.Nonnull PolicyInfo policy) {
    this.policy = policy;
    return this;
  }

  /**
   * Get policy
   * @return policy
   */
  @javax.annotation.Nonnull
  public PolicyInfo getPolicy() {
    return policy;
  }

  public void setPolicy(@javax.annotation.Nonnull PolicyInfo policy) {
    this.policy = policy;
  }


  public SubmitRun maxWorkers(@javax.annotation.Nullable Integer maxWorkers) {
    this.maxWorkers = maxWorkers;
    return this;
  }

  /**
   * Most live workers wanted; the server&#39;s limit when absent.
   * minimum: 1
   * maximum: 1024
   * @return maxWorkers
   */
  @javax.annotation.Nullable
  public Integer getMaxWorkers() {
    return maxWorkers;
  }

  public void setMaxWorkers(@javax.annotation.Nullable Integer maxWorkers) {
    this.maxWorkers = maxWorkers;
  }


  public SubmitRun idleTimeoutS(@javax.annotation.Nullable Double idleTimeoutS) {
    this.idleTimeoutS = idleTimeoutS;
    return this;
  }

  /**
   * Lease of a session; the server&#39;s maximum when absent.
   * minimum: 1
   * maximum: 86400
   * @return idleTimeoutS
   */
  @javax.annotation.Nullable
  public Double getIdleTimeoutS() {
    return idleTimeoutS;
  }

  public void setIdleTimeoutS(@javax.annotation.Nullable Double idleTimeoutS) {
    this.idleTimeoutS = idleTimeoutS;
  }


  public SubmitRun images(@javax.annotation.Nullable ImageChoice images) {
    this.images = images;
    return this;
  }

  /**
   * Get images
   * @return images
   */
  @javax.annotation.Nullable
  public ImageChoice getImages() {
    return images;
  }

  public void setImages(@javax.annotation.Nullable ImageChoice images) {
    this.images = images;
  }


  public SubmitRun options(@javax.annotation.Nullable CalibrationOptions options) {
    this.options = options;
    return this;
  }

  /**
   * Get options
   * @return options
   */
  @javax.annotation.Nullable
  public CalibrationOptions getOptions() {
    return options;
  }

  public void setOptions(@javax.annotation.Nullable CalibrationOptions options) {
    this.options = options;
  }


  public SubmitRun mode(@javax.annotation.Nullable RunMode mode) {
    this.mode = mode;
    return this;
  }

  /**
   * Get mode
   * @return mode
   */
  @javax.annotation.Nullable
  public RunMode getMode() {
    return mode;
  }

  public void setMode(@javax.annotation.Nullable RunMode mode) {
    this.mode = mode;
  }


  public SubmitRun policyServer(@javax.annotation.Nullable PolicyServer policyServer) {
    this.policyServer = policyServer;
    return this;
  }

  /**
   * Get policyServer
   * @return policyServer
   */
  @javax.annotation.Nullable
  public PolicyServer getPolicyServer() {
    return policyServer;
  }

  public void setPolicyServer(@javax.annotation.Nullable PolicyServer policyServer) {
    this.policyServer = policyServer;
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
   * @return the SubmitRun instance itself
   */
  public SubmitRun putAdditionalProperty(String key, Object value) {
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
    SubmitRun submitRun = (SubmitRun) o;
    return Objects.equals(this.benchmarkId, submitRun.benchmarkId) &&
        Objects.equals(this.policy, submitRun.policy) &&
        Objects.equals(this.maxWorkers, submitRun.maxWorkers) &&
        Objects.equals(this.idleTimeoutS, submitRun.idleTimeoutS) &&
        Objects.equals(this.images, submitRun.images) &&
        Objects.equals(this.options, submitRun.options) &&
        Objects.equals(this.mode, submitRun.mode) &&
        Objects.equals(this.policyServer, submitRun.policyServer)&&
        Objects.equals(this.additionalProperties, submitRun.additionalProperties);
  }

  @Override
  public int hashCode() {
    return Objects.hash(benchmarkId, policy, maxWorkers, idleTimeoutS, images, options, mode, policyServer, additionalProperties);
  }

  @Override
  public String toString() {
    StringBuilder sb = new StringBuilder();
    sb.append("class SubmitRun {\n");
    sb.append("    benchmarkId: ").append(toIndentedString(benchmarkId)).append("\n");
    sb.append("    policy: ").append(toIndentedString(policy)).append("\n");
    sb.append("    maxWorkers: ").append(toIndentedString(maxWorkers)).append("\n");
    sb.append("    idleTimeoutS: ").append(toIndentedString(idleTimeoutS)).append("\n");
    sb.append("    images: ").append(toIndentedString(images)).append("\n");
    sb.append("    options: ").append(toIndentedString(options)).append("\n");
    sb.append("    mode: ").append(toIndentedString(mode)).append("\n");
    sb.append("    policyServer: ").append(toIndentedString(policyServer)).append("\n");
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
    openapiFields = new HashSet<String>(Arrays.asList("benchmark_id", "policy", "max_workers", "idle_timeout_s", "images", "options", "mode", "policy_server"));

    // a set of required properties/fields (JSON key names)
    openapiRequiredFields = new HashSet<String>(Arrays.asList("benchmark_id", "policy"));
  }

  /**
   * Validates the JSON Element and throws an exception if issues found
   *
   * @param jsonElement JSON Element
   * @throws IOException if the JSON Element is invalid with respect to SubmitRun
   */
  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
      if (jsonElement == null) {
        if (!SubmitRun.openapiRequiredFields.isEmpty()) { // has required fields but JSON element is null
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field(s) %s in SubmitRun is not found in the empty JSON string", SubmitRun.openapiRequiredFields.toString()));
        }
      }

      // check to make sure all required properties/fields are present in the JSON string
      for (String requiredField : SubmitRun.openapiRequiredFields) {
        if (jsonElement.getAsJsonObject().get(requiredField) == null) {
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field `%s` is not found in the JSON string: %s", requiredField, jsonElement.toString()));
        }
      }
        JsonObject jsonObj = jsonElement.getAsJsonObject();
      if (!jsonObj.get("benchmark_id").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `benchmark_id` to be a primitive type in the JSON string but got `%s`", jsonObj.get("benchmark_id").toString()));
      }
      // validate the required field `policy`
      PolicyInfo.validateJsonElement(jsonObj.get("policy"));
      // validate the optional field `images`
      if (jsonObj.get("images") != null && !jsonObj.get("images").isJsonNull()) {
        ImageChoice.validateJsonElement(jsonObj.get("images"));
      }
      // validate the optional field `options`
      if (jsonObj.get("options") != null && !jsonObj.get("options").isJsonNull()) {
        CalibrationOptions.validateJsonElement(jsonObj.get("options"));
      }
      // validate the optional field `mode`
      if (jsonObj.get("mode") != null && !jsonObj.get("mode").isJsonNull()) {
        RunMode.validateJsonElement(jsonObj.get("mode"));
      }
      // validate the optional field `policy_server`
      if (jsonObj.get("policy_server") != null && !jsonObj.get("policy_server").isJsonNull()) {
        PolicyServer.validateJsonElement(jsonObj.get("policy_server"));
      }
  }

  public static class CustomTypeAdapterFactory implements TypeAdapterFactory {
    @SuppressWarnings("unchecked")
    @Override
    public <T> TypeAdapter<T> create(Gson gson, TypeToken<T> type) {
       if (!SubmitRun.class.isAssignableFrom(type.getRawType())) {
         return null; // this class only serializes 'SubmitRun' and its subtypes
       }
       final TypeAdapter<JsonElement> elementAdapter = gson.getAdapter(JsonElement.class);
       final TypeAdapter<SubmitRun> thisAdapter
                        = gson.getDelegateAdapter(this, TypeToken.get(SubmitRun.class));

       return (TypeAdapter<T>) new TypeAdapter<SubmitRun>() {
           @Override
           public void write(JsonWriter out, SubmitRun value) throws IOException {
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
           public SubmitRun read(JsonReader in) throws IOException {
             JsonElement jsonElement = elementAdapter.read(in);
             validateJsonElement(jsonElement);
             JsonObject jsonObj = jsonElement.getAsJsonObject();
             // store additional fields in the deserialized instance
             SubmitRun instance = thisAdapter.fromJsonTree(jsonObj);
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
   * Create an instance of SubmitRun given an JSON string
   *
   * @param jsonString JSON string
   * @return An instance of SubmitRun
   * @throws IOException if the JSON string is invalid with respect to SubmitRun
   */
  public static SubmitRun fromJson(String jsonString) throws IOException {
    return JSON.getGson().fromJson(jsonString, SubmitRun.class);
  }

  /**
   * Convert an instance of SubmitRun to an JSON string
   *
   * @return JSON string
   */
  public String toJson() {
    return JSON.getGson().toJson(this);
  }
}
