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
import java.time.OffsetDateTime;
import java.util.Arrays;
import proctor.client.model.ImageChoice;
import proctor.client.model.PolicyInfo;
import proctor.client.model.PolicyServerView;
import proctor.client.model.Progress;
import proctor.client.model.RunState;

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
 * Run
 */
@javax.annotation.Generated(value = "org.openapitools.codegen.languages.JavaClientCodegen", comments = "Generator version: 7.26.0")
public class Run {
  public static final String SERIALIZED_NAME_RUN_ID = "run_id";
  @SerializedName(SERIALIZED_NAME_RUN_ID)
  @javax.annotation.Nonnull
  private String runId;

  public static final String SERIALIZED_NAME_STATE = "state";
  @SerializedName(SERIALIZED_NAME_STATE)
  @javax.annotation.Nonnull
  private RunState state;

  public static final String SERIALIZED_NAME_REASON = "reason";
  @SerializedName(SERIALIZED_NAME_REASON)
  @javax.annotation.Nullable
  private String reason;

  public static final String SERIALIZED_NAME_RETRYABLE = "retryable";
  @SerializedName(SERIALIZED_NAME_RETRYABLE)
  @javax.annotation.Nullable
  private Boolean retryable;

  public static final String SERIALIZED_NAME_BENCHMARK_ID = "benchmark_id";
  @SerializedName(SERIALIZED_NAME_BENCHMARK_ID)
  @javax.annotation.Nonnull
  private String benchmarkId;

  public static final String SERIALIZED_NAME_BENCHMARK_VERSION = "benchmark_version";
  @SerializedName(SERIALIZED_NAME_BENCHMARK_VERSION)
  @javax.annotation.Nonnull
  private String benchmarkVersion;

  public static final String SERIALIZED_NAME_MANIFEST_SHA256 = "manifest_sha256";
  @SerializedName(SERIALIZED_NAME_MANIFEST_SHA256)
  @javax.annotation.Nonnull
  private String manifestSha256;

  public static final String SERIALIZED_NAME_POLICY = "policy";
  @SerializedName(SERIALIZED_NAME_POLICY)
  @javax.annotation.Nonnull
  private PolicyInfo policy;

  public static final String SERIALIZED_NAME_MODE = "mode";
  @SerializedName(SERIALIZED_NAME_MODE)
  @javax.annotation.Nullable
  private String mode;

  public static final String SERIALIZED_NAME_POLICY_SERVER = "policy_server";
  @SerializedName(SERIALIZED_NAME_POLICY_SERVER)
  @javax.annotation.Nullable
  private PolicyServerView policyServer;

  public static final String SERIALIZED_NAME_MAX_WORKERS = "max_workers";
  @SerializedName(SERIALIZED_NAME_MAX_WORKERS)
  @javax.annotation.Nonnull
  private Integer maxWorkers;

  public static final String SERIALIZED_NAME_IDLE_TIMEOUT_S = "idle_timeout_s";
  @SerializedName(SERIALIZED_NAME_IDLE_TIMEOUT_S)
  @javax.annotation.Nonnull
  private Double idleTimeoutS;

  public static final String SERIALIZED_NAME_IMAGES = "images";
  @SerializedName(SERIALIZED_NAME_IMAGES)
  @javax.annotation.Nonnull
  private ImageChoice images;

  public static final String SERIALIZED_NAME_ENDPOINT = "endpoint";
  @SerializedName(SERIALIZED_NAME_ENDPOINT)
  @javax.annotation.Nonnull
  private String endpoint;

  public static final String SERIALIZED_NAME_QUEUE_POSITION = "queue_position";
  @SerializedName(SERIALIZED_NAME_QUEUE_POSITION)
  @javax.annotation.Nullable
  private Integer queuePosition;

  public static final String SERIALIZED_NAME_LIVE_WORKERS = "live_workers";
  @SerializedName(SERIALIZED_NAME_LIVE_WORKERS)
  @javax.annotation.Nonnull
  private Integer liveWorkers;

  public static final String SERIALIZED_NAME_PROGRESS = "progress";
  @SerializedName(SERIALIZED_NAME_PROGRESS)
  @javax.annotation.Nonnull
  private Progress progress;

  public static final String SERIALIZED_NAME_CREATED_AT = "created_at";
  @SerializedName(SERIALIZED_NAME_CREATED_AT)
  @javax.annotation.Nonnull
  private OffsetDateTime createdAt;

  public static final String SERIALIZED_NAME_UPDATED_AT = "updated_at";
  @SerializedName(SERIALIZED_NAME_UPDATED_AT)
  @javax.annotation.Nonnull
  private OffsetDateTime updatedAt;

  public Run() {
  }

  public Run runId(@javax.annotation.Nonnull String runId) {
    this.runId = runId;
    return this;
  }

  /**
   * Get runId
   * @return runId
   */
  @javax.annotation.Nonnull
  public String getRunId() {
    return runId;
  }

  public void setRunId(@javax.annotation.Nonnull String runId) {
    this.runId = runId;
  }


  public Run state(@javax.annotation.Nonnull RunState state) {
    this.state = state;
    return this;
  }

  /**
   * Get state
   * @return state
   */
  @javax.annotation.Nonnull
  public RunState getState() {
    return state;
  }

  public void setState(@javax.annotation.Nonnull RunState state) {
    this.state = state;
  }


  public Run reason(@javax.annotation.Nullable String reason) {
    this.reason = reason;
    return this;
  }

  /**
   * Why the run is in this state, for people; never null when failed.
   * @return reason
   */
  @javax.annotation.Nullable
  public String getReason() {
    return reason;
  }

  public void setReason(@javax.annotation.Nullable String reason) {
    this.reason = reason;
  }


  public Run retryable(@javax.annotation.Nullable Boolean retryable) {
    this.retryable = retryable;
    return this;
  }

  /**
   * Whether a failed run may be resumed; null in other states.
   * @return retryable
   */
  @javax.annotation.Nullable
  public Boolean getRetryable() {
    return retryable;
  }

  public void setRetryable(@javax.annotation.Nullable Boolean retryable) {
    this.retryable = retryable;
  }


  public Run benchmarkId(@javax.annotation.Nonnull String benchmarkId) {
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


  public Run benchmarkVersion(@javax.annotation.Nonnull String benchmarkVersion) {
    this.benchmarkVersion = benchmarkVersion;
    return this;
  }

  /**
   * Get benchmarkVersion
   * @return benchmarkVersion
   */
  @javax.annotation.Nonnull
  public String getBenchmarkVersion() {
    return benchmarkVersion;
  }

  public void setBenchmarkVersion(@javax.annotation.Nonnull String benchmarkVersion) {
    this.benchmarkVersion = benchmarkVersion;
  }


  public Run manifestSha256(@javax.annotation.Nonnull String manifestSha256) {
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


  public Run policy(@javax.annotation.Nonnull PolicyInfo policy) {
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


  public Run mode(@javax.annotation.Nullable String mode) {
    this.mode = mode;
    return this;
  }

  /**
   * A &#x60;RunMode&#x60;, or one of a later version; &#x60;pull&#x60; when absent.
   * @return mode
   */
  @javax.annotation.Nullable
  public String getMode() {
    return mode;
  }

  public void setMode(@javax.annotation.Nullable String mode) {
    this.mode = mode;
  }


  public Run policyServer(@javax.annotation.Nullable PolicyServerView policyServer) {
    this.policyServer = policyServer;
    return this;
  }

  /**
   * Get policyServer
   * @return policyServer
   */
  @javax.annotation.Nullable
  public PolicyServerView getPolicyServer() {
    return policyServer;
  }

  public void setPolicyServer(@javax.annotation.Nullable PolicyServerView policyServer) {
    this.policyServer = policyServer;
  }


  public Run maxWorkers(@javax.annotation.Nonnull Integer maxWorkers) {
    this.maxWorkers = maxWorkers;
    return this;
  }

  /**
   * Get maxWorkers
   * @return maxWorkers
   */
  @javax.annotation.Nonnull
  public Integer getMaxWorkers() {
    return maxWorkers;
  }

  public void setMaxWorkers(@javax.annotation.Nonnull Integer maxWorkers) {
    this.maxWorkers = maxWorkers;
  }


  public Run idleTimeoutS(@javax.annotation.Nonnull Double idleTimeoutS) {
    this.idleTimeoutS = idleTimeoutS;
    return this;
  }

  /**
   * Get idleTimeoutS
   * @return idleTimeoutS
   */
  @javax.annotation.Nonnull
  public Double getIdleTimeoutS() {
    return idleTimeoutS;
  }

  public void setIdleTimeoutS(@javax.annotation.Nonnull Double idleTimeoutS) {
    this.idleTimeoutS = idleTimeoutS;
  }


  public Run images(@javax.annotation.Nonnull ImageChoice images) {
    this.images = images;
    return this;
  }

  /**
   * Get images
   * @return images
   */
  @javax.annotation.Nonnull
  public ImageChoice getImages() {
    return images;
  }

  public void setImages(@javax.annotation.Nonnull ImageChoice images) {
    this.images = images;
  }


  public Run endpoint(@javax.annotation.Nonnull String endpoint) {
    this.endpoint = endpoint;
    return this;
  }

  /**
   * Base URL of the data plane for this run; the path of an operation is appended to it.
   * @return endpoint
   */
  @javax.annotation.Nonnull
  public String getEndpoint() {
    return endpoint;
  }

  public void setEndpoint(@javax.annotation.Nonnull String endpoint) {
    this.endpoint = endpoint;
  }


  public Run queuePosition(@javax.annotation.Nullable Integer queuePosition) {
    this.queuePosition = queuePosition;
    return this;
  }

  /**
   * 1 is next; null unless queued.
   * @return queuePosition
   */
  @javax.annotation.Nullable
  public Integer getQueuePosition() {
    return queuePosition;
  }

  public void setQueuePosition(@javax.annotation.Nullable Integer queuePosition) {
    this.queuePosition = queuePosition;
  }


  public Run liveWorkers(@javax.annotation.Nonnull Integer liveWorkers) {
    this.liveWorkers = liveWorkers;
    return this;
  }

  /**
   * Get liveWorkers
   * minimum: 0
   * @return liveWorkers
   */
  @javax.annotation.Nonnull
  public Integer getLiveWorkers() {
    return liveWorkers;
  }

  public void setLiveWorkers(@javax.annotation.Nonnull Integer liveWorkers) {
    this.liveWorkers = liveWorkers;
  }


  public Run progress(@javax.annotation.Nonnull Progress progress) {
    this.progress = progress;
    return this;
  }

  /**
   * Get progress
   * @return progress
   */
  @javax.annotation.Nonnull
  public Progress getProgress() {
    return progress;
  }

  public void setProgress(@javax.annotation.Nonnull Progress progress) {
    this.progress = progress;
  }


  public Run createdAt(@javax.annotation.Nonnull OffsetDateTime createdAt) {
    this.createdAt = createdAt;
    return this;
  }

  /**
   * Get createdAt
   * @return createdAt
   */
  @javax.annotation.Nonnull
  public OffsetDateTime getCreatedAt() {
    return createdAt;
  }

  public void setCreatedAt(@javax.annotation.Nonnull OffsetDateTime createdAt) {
    this.createdAt = createdAt;
  }


  public Run updatedAt(@javax.annotation.Nonnull OffsetDateTime updatedAt) {
    this.updatedAt = updatedAt;
    return this;
  }

  /**
   * Get updatedAt
   * @return updatedAt
   */
  @javax.annotation.Nonnull
  public OffsetDateTime getUpdatedAt() {
    return updatedAt;
  }

  public void setUpdatedAt(@javax.annotation.Nonnull OffsetDateTime updatedAt) {
    this.updatedAt = updatedAt;
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
   * @return the Run instance itself
   */
  public Run putAdditionalProperty(String key, Object value) {
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
    Run run = (Run) o;
    return Objects.equals(this.runId, run.runId) &&
        Objects.equals(this.state, run.state) &&
        Objects.equals(this.reason, run.reason) &&
        Objects.equals(this.retryable, run.retryable) &&
        Objects.equals(this.benchmarkId, run.benchmarkId) &&
        Objects.equals(this.benchmarkVersion, run.benchmarkVersion) &&
        Objects.equals(this.manifestSha256, run.manifestSha256) &&
        Objects.equals(this.policy, run.policy) &&
        Objects.equals(this.mode, run.mode) &&
        Objects.equals(this.policyServer, run.policyServer) &&
        Objects.equals(this.maxWorkers, run.maxWorkers) &&
        Objects.equals(this.idleTimeoutS, run.idleTimeoutS) &&
        Objects.equals(this.images, run.images) &&
        Objects.equals(this.endpoint, run.endpoint) &&
        Objects.equals(this.queuePosition, run.queuePosition) &&
        Objects.equals(this.liveWorkers, run.liveWorkers) &&
        Objects.equals(this.progress, run.progress) &&
        Objects.equals(this.createdAt, run.createdAt) &&
        Objects.equals(this.updatedAt, run.updatedAt)&&
        Objects.equals(this.additionalProperties, run.additionalProperties);
  }

  @Override
  public int hashCode() {
    return Objects.hash(runId, state, reason, retryable, benchmarkId, benchmarkVersion, manifestSha256, policy, mode, policyServer, maxWorkers, idleTimeoutS, images, endpoint, queuePosition, liveWorkers, progress, createdAt, updatedAt, additionalProperties);
  }

  @Override
  public String toString() {
    StringBuilder sb = new StringBuilder();
    sb.append("class Run {\n");
    sb.append("    runId: ").append(toIndentedString(runId)).append("\n");
    sb.append("    state: ").append(toIndentedString(state)).append("\n");
    sb.append("    reason: ").append(toIndentedString(reason)).append("\n");
    sb.append("    retryable: ").append(toIndentedString(retryable)).append("\n");
    sb.append("    benchmarkId: ").append(toIndentedString(benchmarkId)).append("\n");
    sb.append("    benchmarkVersion: ").append(toIndentedString(benchmarkVersion)).append("\n");
    sb.append("    manifestSha256: ").append(toIndentedString(manifestSha256)).append("\n");
    sb.append("    policy: ").append(toIndentedString(policy)).append("\n");
    sb.append("    mode: ").append(toIndentedString(mode)).append("\n");
    sb.append("    policyServer: ").append(toIndentedString(policyServer)).append("\n");
    sb.append("    maxWorkers: ").append(toIndentedString(maxWorkers)).append("\n");
    sb.append("    idleTimeoutS: ").append(toIndentedString(idleTimeoutS)).append("\n");
    sb.append("    images: ").append(toIndentedString(images)).append("\n");
    sb.append("    endpoint: ").append(toIndentedString(endpoint)).append("\n");
    sb.append("    queuePosition: ").append(toIndentedString(queuePosition)).append("\n");
    sb.append("    liveWorkers: ").append(toIndentedString(liveWorkers)).append("\n");
    sb.append("    progress: ").append(toIndentedString(progress)).append("\n");
    sb.append("    createdAt: ").append(toIndentedString(createdAt)).append("\n");
    sb.append("    updatedAt: ").append(toIndentedString(updatedAt)).append("\n");
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
    openapiFields = new HashSet<String>(Arrays.asList("run_id", "state", "reason", "retryable", "benchmark_id", "benchmark_version", "manifest_sha256", "policy", "mode", "policy_server", "max_workers", "idle_timeout_s", "images", "endpoint", "queue_position", "live_workers", "progress", "created_at", "updated_at"));

    // a set of required properties/fields (JSON key names)
    openapiRequiredFields = new HashSet<String>(Arrays.asList("run_id", "state", "reason", "retryable", "benchmark_id", "benchmark_version", "manifest_sha256", "policy", "max_workers", "idle_timeout_s", "images", "endpoint", "queue_position", "live_workers", "progress", "created_at", "updated_at"));
  }

  /**
   * Validates the JSON Element and throws an exception if issues found
   *
   * @param jsonElement JSON Element
   * @throws IOException if the JSON Element is invalid with respect to Run
   */
  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
      if (jsonElement == null) {
        if (!Run.openapiRequiredFields.isEmpty()) { // has required fields but JSON element is null
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field(s) %s in Run is not found in the empty JSON string", Run.openapiRequiredFields.toString()));
        }
      }

      // check to make sure all required properties/fields are present in the JSON string
      for (String requiredField : Run.openapiRequiredFields) {
        if (jsonElement.getAsJsonObject().get(requiredField) == null) {
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field `%s` is not found in the JSON string: %s", requiredField, jsonElement.toString()));
        }
      }
        JsonObject jsonObj = jsonElement.getAsJsonObject();
      if (!jsonObj.get("run_id").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `run_id` to be a primitive type in the JSON string but got `%s`", jsonObj.get("run_id").toString()));
      }
      // validate the required field `state`
      RunState.validateJsonElement(jsonObj.get("state"));
      if ((jsonObj.get("reason") != null && !jsonObj.get("reason").isJsonNull()) && !jsonObj.get("reason").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `reason` to be a primitive type in the JSON string but got `%s`", jsonObj.get("reason").toString()));
      }
      if (!jsonObj.get("benchmark_id").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `benchmark_id` to be a primitive type in the JSON string but got `%s`", jsonObj.get("benchmark_id").toString()));
      }
      if (!jsonObj.get("benchmark_version").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `benchmark_version` to be a primitive type in the JSON string but got `%s`", jsonObj.get("benchmark_version").toString()));
      }
      if (!jsonObj.get("manifest_sha256").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `manifest_sha256` to be a primitive type in the JSON string but got `%s`", jsonObj.get("manifest_sha256").toString()));
      }
      // validate the required field `policy`
      PolicyInfo.validateJsonElement(jsonObj.get("policy"));
      if ((jsonObj.get("mode") != null && !jsonObj.get("mode").isJsonNull()) && !jsonObj.get("mode").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `mode` to be a primitive type in the JSON string but got `%s`", jsonObj.get("mode").toString()));
      }
      // validate the required field `images`
      ImageChoice.validateJsonElement(jsonObj.get("images"));
      if (!jsonObj.get("endpoint").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `endpoint` to be a primitive type in the JSON string but got `%s`", jsonObj.get("endpoint").toString()));
      }
  }

  public static class CustomTypeAdapterFactory implements TypeAdapterFactory {
    @SuppressWarnings("unchecked")
    @Override
    public <T> TypeAdapter<T> create(Gson gson, TypeToken<T> type) {
       if (!Run.class.isAssignableFrom(type.getRawType())) {
         return null; // this class only serializes 'Run' and its subtypes
       }
       final TypeAdapter<JsonElement> elementAdapter = gson.getAdapter(JsonElement.class);
       final TypeAdapter<Run> thisAdapter
                        = gson.getDelegateAdapter(this, TypeToken.get(Run.class));

       return (TypeAdapter<T>) new TypeAdapter<Run>() {
           @Override
           public void write(JsonWriter out, Run value) throws IOException {
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
           public Run read(JsonReader in) throws IOException {
             JsonElement jsonElement = elementAdapter.read(in);
             validateJsonElement(jsonElement);
             JsonObject jsonObj = jsonElement.getAsJsonObject();
             // store additional fields in the deserialized instance
             Run instance = thisAdapter.fromJsonTree(jsonObj);
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
   * Create an instance of Run given an JSON string
   *
   * @param jsonString JSON string
   * @return An instance of Run
   * @throws IOException if the JSON string is invalid with respect to Run
   */
  public static Run fromJson(String jsonString) throws IOException {
    return JSON.getGson().fromJson(jsonString, Run.class);
  }

  /**
   * Convert an instance of Run to an JSON string
   *
   * @return JSON string
   */
  public String toJson() {
    return JSON.getGson().toJson(this);
  }
}
