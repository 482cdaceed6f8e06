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
import java.util.HashMap;
import java.util.Map;
import proctor.client.model.PolicyProtocol;

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
 * Where the server finds the policy of a run with mode &#x60;push&#x60;, and how it calls it.
 */
@javax.annotation.Generated(value = "org.openapitools.codegen.languages.JavaClientCodegen", comments = "Generator version: 7.26.0")
public class PolicyServer {
  public static final String SERIALIZED_NAME_URL = "url";
  @SerializedName(SERIALIZED_NAME_URL)
  @javax.annotation.Nonnull
  private String url;

  public static final String SERIALIZED_NAME_PROTOCOL = "protocol";
  @SerializedName(SERIALIZED_NAME_PROTOCOL)
  @javax.annotation.Nonnull
  private PolicyProtocol protocol;

  public static final String SERIALIZED_NAME_API_KEY = "api_key";
  @SerializedName(SERIALIZED_NAME_API_KEY)
  @javax.annotation.Nullable
  private String apiKey;

  public static final String SERIALIZED_NAME_MODEL = "model";
  @SerializedName(SERIALIZED_NAME_MODEL)
  @javax.annotation.Nullable
  private String model;

  public static final String SERIALIZED_NAME_CALL_TIMEOUT_S = "call_timeout_s";
  @SerializedName(SERIALIZED_NAME_CALL_TIMEOUT_S)
  @javax.annotation.Nullable
  private Double callTimeoutS;

  public static final String SERIALIZED_NAME_MAX_CONCURRENT = "max_concurrent";
  @SerializedName(SERIALIZED_NAME_MAX_CONCURRENT)
  @javax.annotation.Nullable
  private Integer maxConcurrent;

  public static final String SERIALIZED_NAME_MAX_RETRIES = "max_retries";
  @SerializedName(SERIALIZED_NAME_MAX_RETRIES)
  @javax.annotation.Nullable
  private Integer maxRetries;

  public static final String SERIALIZED_NAME_GENERATION = "generation";
  @SerializedName(SERIALIZED_NAME_GENERATION)
  @javax.annotation.Nullable
  private Map<String, Double> generation;

  public PolicyServer() {
  }

  public PolicyServer url(@javax.annotation.Nonnull String url) {
    this.url = url;
    return this;
  }

  /**
   * Base URL, without user, query or fragment; the path of an operation is appended to it.
   * @return url
   */
  @javax.annotation.Nonnull
  public String getUrl() {
    return url;
  }

  public void setUrl(@javax.annotation.Nonnull String url) {
    this.url = url;
  }


  public PolicyServer protocol(@javax.annotation.Nonnull PolicyProtocol protocol) {
    this.protocol = protocol;
    return this;
  }

  /**
   * Get protocol
   * @return protocol
   */
  @javax.annotation.Nonnull
  public PolicyProtocol getProtocol() {
    return protocol;
  }

  public void setProtocol(@javax.annotation.Nonnull PolicyProtocol protocol) {
    this.protocol = protocol;
  }


  public PolicyServer apiKey(@javax.annotation.Nullable String apiKey) {
    this.apiKey = apiKey;
    return this;
  }

  /**
   * Sent as bearer token with every call, and shown to nobody.
   * @return apiKey
   */
  @javax.annotation.Nullable
  public String getApiKey() {
    return apiKey;
  }

  public void setApiKey(@javax.annotation.Nullable String apiKey) {
    this.apiKey = apiKey;
  }


  public PolicyServer model(@javax.annotation.Nullable String model) {
    this.model = model;
    return this;
  }

  /**
   * Which model is asked, where a protocol knows several.
   * @return model
   */
  @javax.annotation.Nullable
  public String getModel() {
    return model;
  }

  public void setModel(@javax.annotation.Nullable String model) {
    this.model = model;
  }


  public PolicyServer callTimeoutS(@javax.annotation.Nullable Double callTimeoutS) {
    this.callTimeoutS = callTimeoutS;
    return this;
  }

  /**
   * Time for one call, from connecting to the last byte of its answer; 30 when absent.
   * minimum: 0.1
   * maximum: 600
   * @return callTimeoutS
   */
  @javax.annotation.Nullable
  public Double getCallTimeoutS() {
    return callTimeoutS;
  }

  public void setCallTimeoutS(@javax.annotation.Nullable Double callTimeoutS) {
    this.callTimeoutS = callTimeoutS;
  }


  public PolicyServer maxConcurrent(@javax.annotation.Nullable Integer maxConcurrent) {
    this.maxConcurrent = maxConcurrent;
    return this;
  }

  /**
   * Most episodes played and calls made at a time; as many as the policy, the run and the server allow when absent.
   * minimum: 1
   * maximum: 1024
   * @return maxConcurrent
   */
  @javax.annotation.Nullable
  public Integer getMaxConcurrent() {
    return maxConcurrent;
  }

  public void setMaxConcurrent(@javax.annotation.Nullable Integer maxConcurrent) {
    this.maxConcurrent = maxConcurrent;
  }


  public PolicyServer maxRetries(@javax.annotation.Nullable Integer maxRetries) {
    this.maxRetries = maxRetries;
    return this;
  }

  /**
   * How often a call that was not answered is repeated; 3 when absent.
   * minimum: 0
   * maximum: 10
   * @return maxRetries
   */
  @javax.annotation.Nullable
  public Integer getMaxRetries() {
    return maxRetries;
  }

  public void setMaxRetries(@javax.annotation.Nullable Integer maxRetries) {
    this.maxRetries = maxRetries;
  }


  public PolicyServer generation(@javax.annotation.Nullable Map<String, Double> generation) {
    this.generation = generation;
    return this;
  }

  public PolicyServer putGenerationItem(String key, Double generationItem) {
    if (this.generation == null) {
      this.generation = new HashMap<>();
    }
    this.generation.put(key, generationItem);
    return this;
  }

  /**
   * Numbers that a chat completion is asked with, such as &#x60;temperature&#x60; and &#x60;max_tokens&#x60;; for &#x60;openai_chat&#x60; alone.
   * @return generation
   */
  @javax.annotation.Nullable
  public Map<String, Double> getGeneration() {
    return generation;
  }

  public void setGeneration(@javax.annotation.Nullable Map<String, Double> generation) {
    this.generation = generation;
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
   * @return the PolicyServer instance itself
   */
  public PolicyServer putAdditionalProperty(String key, Object value) {
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
    PolicyServer policyServer = (PolicyServer) o;
    return Objects.equals(this.url, policyServer.url) &&
        Objects.equals(this.protocol, policyServer.protocol) &&
        Objects.equals(this.apiKey, policyServer.apiKey) &&
        Objects.equals(this.model, policyServer.model) &&
        Objects.equals(this.callTimeoutS, policyServer.callTimeoutS) &&
        Objects.equals(this.maxConcurrent, policyServer.maxConcurrent) &&
        Objects.equals(this.maxRetries, policyServer.maxRetries) &&
        Objects.equals(this.generation, policyServer.generation)&&
        Objects.equals(this.additionalProperties, policyServer.additionalProperties);
  }

  @Override
  public int hashCode() {
    return Objects.hash(url, protocol, apiKey, model, callTimeoutS, maxConcurrent, maxRetries, generation, additionalProperties);
  }

  @Override
  public String toString() {
    StringBuilder sb = new StringBuilder();
    sb.append("class PolicyServer {\n");
    sb.append("    url: ").append(toIndentedString(url)).append("\n");
    sb.append("    protocol: ").append(toIndentedString(protocol)).append("\n");
    sb.append("    apiKey: ").append(toIndentedString(apiKey)).append("\n");
    sb.append("    model: ").append(toIndentedString(model)).append("\n");
    sb.append("    callTimeoutS: ").append(toIndentedString(callTimeoutS)).append("\n");
    sb.append("    maxConcurrent: ").append(toIndentedString(maxConcurrent)).append("\n");
    sb.append("    maxRetries: ").append(toIndentedString(maxRetries)).append("\n");
    sb.append("    generation: ").append(toIndentedString(generation)).append("\n");
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
    openapiFields = new HashSet<String>(Arrays.asList("url", "protocol", "api_key", "model", "call_timeout_s", "max_concurrent", "max_retries", "generation"));

    // a set of required properties/fields (JSON key names)
    openapiRequiredFields = new HashSet<String>(Arrays.asList("url", "protocol"));
  }

  /**
   * Validates the JSON Element and throws an exception if issues found
   *
   * @param jsonElement JSON Element
   * @throws IOException if the JSON Element is invalid with respect to PolicyServer
   */
  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
      if (jsonElement == null) {
        if (!PolicyServer.openapiRequiredFields.isEmpty()) { // has required fields but JSON element is null
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field(s) %s in PolicyServer is not found in the empty JSON string", PolicyServer.openapiRequiredFields.toString()));
        }
      }

      // check to make sure all required properties/fields are present in the JSON string
      for (String requiredField : PolicyServer.openapiRequiredFields) {
        if (jsonElement.getAsJsonObject().get(requiredField) == null) {
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field `%s` is not found in the JSON string: %s", requiredField, jsonElement.toString()));
        }
      }
        JsonObject jsonObj = jsonElement.getAsJsonObject();
      if (!jsonObj.get("url").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `url` to be a primitive type in the JSON string but got `%s`", jsonObj.get("url").toString()));
      }
      // validate the required field `protocol`
      PolicyProtocol.validateJsonElement(jsonObj.get("protocol"));
      if ((jsonObj.get("api_key") != null && !jsonObj.get("api_key").isJsonNull()) && !jsonObj.get("api_key").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `api_key` to be a primitive type in the JSON string but got `%s`", jsonObj.get("api_key").toString()));
      }
      if ((jsonObj.get("model") != null && !jsonObj.get("model").isJsonNull()) && !jsonObj.get("model").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `model` to be a primitive type in the JSON string but got `%s`", jsonObj.get("model").toString()));
      }
  }

  public static class CustomTypeAdapterFactory implements TypeAdapterFactory {
    @SuppressWarnings("unchecked")
    @Override
    public <T> TypeAdapter<T> create(Gson gson, TypeToken<T> type) {
       if (!PolicyServer.class.isAssignableFrom(type.getRawType())) {
         return null; // this class only serializes 'PolicyServer' and its subtypes
       }
       final TypeAdapter<JsonElement> elementAdapter = gson.getAdapter(JsonElement.class);
       final TypeAdapter<PolicyServer> thisAdapter
                        = gson.getDelegateAdapter(this, TypeToken.get(PolicyServer.class));

       return (TypeAdapter<T>) new TypeAdapter<PolicyServer>() {
           @Override
           public void write(JsonWriter out, PolicyServer value) throws IOException {
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
           public PolicyServer read(JsonReader in) throws IOException {
             JsonElement jsonElement = elementAdapter.read(in);
             validateJsonElement(jsonElement);
             JsonObject jsonObj = jsonElement.getAsJsonObject();
             // store additional fields in the deserialized instance
             PolicyServer instance = thisAdapter.fromJsonTree(jsonObj);
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
   * Create an instance of PolicyServer given an JSON string
   *
   * @param jsonString JSON string
   * @return An instance of PolicyServer
   * @throws IOException if the JSON string is invalid with respect to PolicyServer
   */
  public static PolicyServer fromJson(String jsonString) throws IOException {
    return JSON.getGson().fromJson(jsonString, PolicyServer.class);
  }

  /**
   * Convert an instance of PolicyServer to an JSON string
   *
   * @return JSON string
   */
  public String toJson() {
    return JSON.getGson().toJson(this);
  }
}
