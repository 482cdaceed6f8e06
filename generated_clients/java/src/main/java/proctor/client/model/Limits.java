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
 * Limits
 */
@javax.annotation.Generated(value = "org.openapitools.codegen.languages.JavaClientCodegen", comments = "Generator version: 7.26.0")
public class Limits {
  public static final String SERIALIZED_NAME_MAX_BODY_BYTES = "max_body_bytes";
  @SerializedName(SERIALIZED_NAME_MAX_BODY_BYTES)
  @javax.annotation.Nonnull
  private Long maxBodyBytes;

  public static final String SERIALIZED_NAME_MAX_WORKERS = "max_workers";
  @SerializedName(SERIALIZED_NAME_MAX_WORKERS)
  @javax.annotation.Nonnull
  private Integer maxWorkers;

  public static final String SERIALIZED_NAME_MAX_CHUNK = "max_chunk";
  @SerializedName(SERIALIZED_NAME_MAX_CHUNK)
  @javax.annotation.Nonnull
  private Integer maxChunk;

  public static final String SERIALIZED_NAME_IDLE_TIMEOUT_S_MIN = "idle_timeout_s_min";
  @SerializedName(SERIALIZED_NAME_IDLE_TIMEOUT_S_MIN)
  @javax.annotation.Nonnull
  private Double idleTimeoutSMin;

  public static final String SERIALIZED_NAME_IDLE_TIMEOUT_S_MAX = "idle_timeout_s_max";
  @SerializedName(SERIALIZED_NAME_IDLE_TIMEOUT_S_MAX)
  @javax.annotation.Nonnull
  private Double idleTimeoutSMax;

  public static final String SERIALIZED_NAME_WAIT_S_MAX = "wait_s_max";
  @SerializedName(SERIALIZED_NAME_WAIT_S_MAX)
  @javax.annotation.Nonnull
  private Integer waitSMax;

  public Limits() {
  }

  public Limits maxBodyBytes(@javax.annotation.Nonnull Long maxBodyBytes) {
    this.maxBodyBytes = maxBodyBytes;
    return this;
  }

  /**
   * Longest request body that is read.
   * minimum: 65536
   * @return maxBodyBytes
   */
  @javax.annotation.Nonnull
  public Long getMaxBodyBytes() {
    return maxBodyBytes;
  }

  public void setMaxBodyBytes(@javax.annotation.Nonnull Long maxBodyBytes) {
    this.maxBodyBytes = maxBodyBytes;
  }


  public Limits maxWorkers(@javax.annotation.Nonnull Integer maxWorkers) {
    this.maxWorkers = maxWorkers;
    return this;
  }

  /**
   * Most live workers a run may ask for.
   * minimum: 1
   * @return maxWorkers
   */
  @javax.annotation.Nonnull
  public Integer getMaxWorkers() {
    return maxWorkers;
  }

  public void setMaxWorkers(@javax.annotation.Nonnull Integer maxWorkers) {
    this.maxWorkers = maxWorkers;
  }


  public Limits maxChunk(@javax.annotation.Nonnull Integer maxChunk) {
    this.maxChunk = maxChunk;
    return this;
  }

  /**
   * Most actions in one predict; a benchmark may allow fewer.
   * minimum: 4
   * @return maxChunk
   */
  @javax.annotation.Nonnull
  public Integer getMaxChunk() {
    return maxChunk;
  }

  public void setMaxChunk(@javax.annotation.Nonnull Integer maxChunk) {
    this.maxChunk = maxChunk;
  }


  public Limits idleTimeoutSMin(@javax.annotation.Nonnull Double idleTimeoutSMin) {
    this.idleTimeoutSMin = idleTimeoutSMin;
    return this;
  }

  /**
   * Get idleTimeoutSMin
   * @return idleTimeoutSMin
   */
  @javax.annotation.Nonnull
  public Double getIdleTimeoutSMin() {
    return idleTimeoutSMin;
  }

  public void setIdleTimeoutSMin(@javax.annotation.Nonnull Double idleTimeoutSMin) {
    this.idleTimeoutSMin = idleTimeoutSMin;
  }


  public Limits idleTimeoutSMax(@javax.annotation.Nonnull Double idleTimeoutSMax) {
    this.idleTimeoutSMax = idleTimeoutSMax;
    return this;
  }

  /**
   * Get idleTimeoutSMax
   * @return idleTimeoutSMax
   */
  @javax.annotation.Nonnull
  public Double getIdleTimeoutSMax() {
    return idleTimeoutSMax;
  }

  public void setIdleTimeoutSMax(@javax.annotation.Nonnull Double idleTimeoutSMax) {
    this.idleTimeoutSMax = idleTimeoutSMax;
  }


  public Limits waitSMax(@javax.annotation.Nonnull Integer waitSMax) {
    this.waitSMax = waitSMax;
    return this;
  }

  /**
   * Longest wait that a long-poll is granted.
   * @return waitSMax
   */
  @javax.annotation.Nonnull
  public Integer getWaitSMax() {
    return waitSMax;
  }

  public void setWaitSMax(@javax.annotation.Nonnull Integer waitSMax) {
    this.waitSMax = waitSMax;
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
   * @return the Limits instance itself
   */
  public Limits putAdditionalProperty(String key, Object value) {
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
    Limits limits = (Limits) o;
    return Objects.equals(this.maxBodyBytes, limits.maxBodyBytes) &&
        Objects.equals(this.maxWorkers, limits.maxWorkers) &&
        Objects.equals(this.maxChunk, limits.maxChunk) &&
        Objects.equals(this.idleTimeoutSMin, limits.idleTimeoutSMin) &&
        Objects.equals(this.idleTimeoutSMax, limits.idleTimeoutSMax) &&
        Objects.equals(this.waitSMax, limits.waitSMax)&&
        Objects.equals(this.additionalProperties, limits.additionalProperties);
  }

  @Override
  public int hashCode() {
    return Objects.hash(maxBodyBytes, maxWorkers, maxChunk, idleTimeoutSMin, idleTimeoutSMax, waitSMax, additionalProperties);
  }

  @Override
  public String toString() {
    StringBuilder sb = new StringBuilder();
    sb.append("class Limits {\n");
    sb.append("    maxBodyBytes: ").append(toIndentedString(maxBodyBytes)).append("\n");
    sb.append("    maxWorkers: ").append(toIndentedString(maxWorkers)).append("\n");
    sb.append("    maxChunk: ").append(toIndentedString(maxChunk)).append("\n");
    sb.append("    idleTimeoutSMin: ").append(toIndentedString(idleTimeoutSMin)).append("\n");
    sb.append("    idleTimeoutSMax: ").append(toIndentedString(idleTimeoutSMax)).append("\n");
    sb.append("    waitSMax: ").append(toIndentedString(waitSMax)).append("\n");
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
    openapiFields = new HashSet<String>(Arrays.asList("max_body_bytes", "max_workers", "max_chunk", "idle_timeout_s_min", "idle_timeout_s_max", "wait_s_max"));

    // a set of required properties/fields (JSON key names)
    openapiRequiredFields = new HashSet<String>(Arrays.asList("max_body_bytes", "max_workers", "max_chunk", "idle_timeout_s_min", "idle_timeout_s_max", "wait_s_max"));
  }

  /**
   * Validates the JSON Element and throws an exception if issues found
   *
   * @param jsonElement JSON Element
   * @throws IOException if the JSON Element is invalid with respect to Limits
   */
  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
      if (jsonElement == null) {
        if (!Limits.openapiRequiredFields.isEmpty()) { // has required fields but JSON element is null
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field(s) %s in Limits is not found in the empty JSON string", Limits.openapiRequiredFields.toString()));
        }
      }

      // check to make sure all required properties/fields are present in the JSON string
      for (String requiredField : Limits.openapiRequiredFields) {
        if (jsonElement.getAsJsonObject().get(requiredField) == null) {
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field `%s` is not found in the JSON string: %s", requiredField, jsonElement.toString()));
        }
      }
        JsonObject jsonObj = jsonElement.getAsJsonObject();
  }

  public static class CustomTypeAdapterFactory implements TypeAdapterFactory {
    @SuppressWarnings("unchecked")
    @Override
    public <T> TypeAdapter<T> create(Gson gson, TypeToken<T> type) {
       if (!Limits.class.isAssignableFrom(type.getRawType())) {
         return null; // this class only serializes 'Limits' and its subtypes
       }
       final TypeAdapter<JsonElement> elementAdapter = gson.getAdapter(JsonElement.class);
       final TypeAdapter<Limits> thisAdapter
                        = gson.getDelegateAdapter(this, TypeToken.get(Limits.class));

       return (TypeAdapter<T>) new TypeAdapter<Limits>() {
           @Override
           public void write(JsonWriter out, Limits value) throws IOException {
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
           public Limits read(JsonReader in) throws IOException {
             JsonElement jsonElement = elementAdapter.read(in);
             validateJsonElement(jsonElement);
             JsonObject jsonObj = jsonElement.getAsJsonObject();
             // store additional fields in the deserialized instance
             Limits instance = thisAdapter.fromJsonTree(jsonObj);
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
   * Create an instance of Limits given an JSON string
   *
   * @param jsonString JSON string
   * @return An instance of Limits
   * @throws IOException if the JSON string is invalid with respect to Limits
   */
  public static Limits fromJson(String jsonString) throws IOException {
    return JSON.getGson().fromJson(jsonString, Limits.class);
  }

  /**
   * Convert an instance of Limits to an JSON string
   *
   * @return JSON string
   */
  public String toJson() {
    return JSON.getGson().toJson(this);
  }
}
