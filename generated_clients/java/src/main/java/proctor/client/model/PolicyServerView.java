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
 * The policy server of a run with mode &#x60;push&#x60;, with what was left open filled in, and without its key.
 */
@javax.annotation.Generated(value = "org.openapitools.codegen.languages.JavaClientCodegen", comments = "Generator version: 7.26.0")
public class PolicyServerView {
  public static final String SERIALIZED_NAME_URL = "url";
  @SerializedName(SERIALIZED_NAME_URL)
  @javax.annotation.Nonnull
  private String url;

  public static final String SERIALIZED_NAME_PROTOCOL = "protocol";
  @SerializedName(SERIALIZED_NAME_PROTOCOL)
  @javax.annotation.Nonnull
  private String protocol;

  public static final String SERIALIZED_NAME_HAS_API_KEY = "has_api_key";
  @SerializedName(SERIALIZED_NAME_HAS_API_KEY)
  @javax.annotation.Nonnull
  private Boolean hasApiKey;

  public static final String SERIALIZED_NAME_MODEL = "model";
  @SerializedName(SERIALIZED_NAME_MODEL)
  @javax.annotation.Nullable
  private String model;

  public static final String SERIALIZED_NAME_CALL_TIMEOUT_S = "call_timeout_s";
  @SerializedName(SERIALIZED_NAME_CALL_TIMEOUT_S)
  @javax.annotation.Nonnull
  private Double callTimeoutS;

  public static final String SERIALIZED_NAME_MAX_CONCURRENT = "max_concurrent";
  @SerializedName(SERIALIZED_NAME_MAX_CONCURRENT)
  @javax.annotation.Nonnull
  private Integer maxConcurrent;

  public static final String SERIALIZED_NAME_MAX_RETRIES = "max_retries";
  @SerializedName(SERIALIZED_NAME_MAX_RETRIES)
  @javax.annotation.Nonnull
  private Integer maxRetries;

  public static final String SERIALIZED_NAME_GENERATION = "generation";
  @SerializedName(SERIALIZED_NAME_GENERATION)
  @javax.annotation.Nullable
  private Map<String, Double> generation;

  public PolicyServerView() {
  }

  public PolicyServerView url(@javax.annotation.Nonnull String url) {
    this.url = url;
    return this;
  }

  /**
   * Get url
   * @return url
   */
  @javax.annotation.Nonnull
  public String getUrl() {
    return url;
  }

  public void setUrl(@javax.annotation.Nonnull String url) {
    this.url = url;
  }


  public PolicyServerView protocol(@javax.annotation.Nonnull String protocol) {
    this.protocol = protocol;
    return this;
  }

  /**
   * A &#x60;PolicyProtocol&#x60;, or one of a later version.
   * @return protocol
   */
  @javax.annotation.Nonnull
  public String getProtocol() {
    return protocol;
  }

  public void setProtocol(@javax.annotation.Nonnull String protocol) {
    this.protocol = protocol;
  }


  public PolicyServerView hasApiKey(@javax.annotation.Nonnull Boolean hasApiKey) {
    this.hasApiKey = hasApiKey;
    return this;
  }

  /**
   * Get hasApiKey
   * @return hasApiKey
   */
  @javax.annotation.Nonnull
  public Boolean getHasApiKey() {
    return hasApiKey;
  }

  public void setHasApiKey(@javax.annotation.Nonnull Boolean hasApiKey) {
    this.hasApiKey = hasApiKey;
  }


  public PolicyServerView model(@javax.annotation.Nullable String model) {
    this.model = model;
    return this;
  }

  /**
   * Get model
   * @return model
   */
  @javax.annotation.Nullable
  public String getModel() {
    return model;
  }

  public void setModel(@javax.annotation.Nullable String model) {
    this.model = model;
  }


  public PolicyServerView callTimeoutS(@javax.annotation.Nonnull Double callTimeoutS) {
    this.callTimeoutS = callTimeoutS;
    return this;
  }

  /**
   * Get callTimeoutS
   * @return callTimeoutS
   */
  @javax.annotation.Nonnull
  public Double getCallTimeoutS() {
    return callTimeoutS;
  }

  public void setCallTimeoutS(@javax.annotation.Nonnull Double callTimeoutS) {
    this.callTimeoutS = callTimeoutS;
  }


  public PolicyServerView maxConcurrent(@javax.annotation.Nonnull Integer maxConcurrent) {
    this.maxConcurrent = maxConcurrent;
    return this;
  }

  /**
   * Get maxConcurrent
   * @return maxConcurrent
   */
  @javax.annotation.Nonnull
  public Integer getMaxConcurrent() {
    return maxConcurrent;
  }

  public void setMaxConcurrent(@javax.annotation.Nonnull Integer maxConcurrent) {
    this.maxConcurrent = maxConcurrent;
  }


  public PolicyServerView maxRetries(@javax.annotation.Nonnull Integer maxRetries) {
    this.maxRetries = maxRetries;
    return this;
  }

  /**
   * Get maxRetries
   * @return maxRetries
   */
  @javax.annotation.Nonnull
  public Integer getMaxRetries() {
    return maxRetries;
  }

  public void setMaxRetries(@javax.annotation.Nonnull Integer maxRetries) {
    this.maxRetries = maxRetries;
  }


  public PolicyServerView generation(@javax.annotation.Nullable Map<String, Double> generation) {
    this.generation = generation;
    return this;
  }

  public PolicyServerView putGenerationItem(String key, Double generationItem) {
    if (this.generation == null) {
      this.generation = new HashMap<>();
    }
    this.generation.put(key, generationItem);
    return this;
  }

  /**
   * Get generation
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
   * @return the PolicyServerView instance itself
   */
  public PolicyServerView putAdditionalProperty(String key, Object value) {
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
    PolicyServerView policyServerView = (PolicyServerView) o;
    return Objects.equals(this.url, policyServerView.url) &&
        Objects.equals(this.protocol, policyServerView.protocol) &&
        Objects.equals(this.hasApiKey, policyServerView.hasApiKey) &&
        Objects.equals(this.model, policyServerView.model) &&
        Objects.equals(this.callTimeoutS, policyServerView.callTimeoutS) &&
        Objects.equals(this.maxConcurrent, policyServerView.maxConcurrent) &&
        Objects.equals(this.maxRetries, policyServerView.maxRetries) &&
        Objects.equals(this.generation, policyServerView.generation)&&
        Objects.equals(this.additionalProperties, policyServerView.additionalProperties);
  }

  @Override
  public int hashCode() {
    return Objects.hash(url, protocol, hasApiKey, model, callTimeoutS, maxConcurrent, maxRetries, generation, additionalProperties);
  }

  @Override
  public String toString() {
    StringBuilder sb = new StringBuilder();
    sb.append("class PolicyServerView {\n");
    sb.append("    url: ").append(toIndentedString(url)).append("\n");
    sb.append("    protocol: ").append(toIndentedString(protocol)).append("\n");
    sb.append("    hasApiKey: ").append(toIndentedString(hasApiKey)).append("\n");
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
    openapiFields = new HashSet<String>(Arrays.asList("url", "protocol", "has_api_key", "model", "call_timeout_s", "max_concurrent", "max_retries", "generation"));

    // a set of required properties/fields (JSON key names)
    openapiRequiredFields = new HashSet<String>(Arrays.asList("url", "protocol", "has_api_key", "call_timeout_s", "max_concurrent", "max_retries"));
  }

  /**
   * Validates the JSON Element and throws an exception if issues found
   *
   * @param jsonElement JSON Element
   * @throws IOException if the JSON Element is invalid with respect to PolicyServerView
   */
  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
      if (jsonElement == null) {
        if (!PolicyServerView.openapiRequiredFields.isEmpty()) { // has required fields but JSON element is null
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field(s) %s in PolicyServerView is not found in the empty JSON string", PolicyServerView.openapiRequiredFields.toString()));
        }
      }

      // check to make sure all required properties/fields are present in the JSON string
      for (String requiredField : PolicyServerView.openapiRequiredFields) {
        if (jsonElement.getAsJsonObject().get(requiredField) == null) {
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field `%s` is not found in the JSON string: %s", requiredField, jsonElement.toString()));
        }
      }
        JsonObject jsonObj = jsonElement.getAsJsonObject();
      if (!jsonObj.get("url").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `url` to be a primitive type in the JSON string but got `%s`", jsonObj.get("url").toString()));
      }
      if (!jsonObj.get("protocol").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `protocol` to be a primitive type in the JSON string but got `%s`", jsonObj.get("protocol").toString()));
      }
      if ((jsonObj.get("model") != null && !jsonObj.get("model").isJsonNull()) && !jsonObj.get("model").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `model` to be a primitive type in the JSON string but got `%s`", jsonObj.get("model").toString()));
      }
  }

  public static class CustomTypeAdapterFactory implements TypeAdapterFactory {
    @SuppressWarnings("unchecked")
    @Override
    public <T> TypeAdapter<T> create(Gson gson, TypeToken<T> type) {
       if (!PolicyServerView.class.isAssignableFrom(type.getRawType())) {
         return null; // this class only serializes 'PolicyServerView' and its subtypes
       }
       final TypeAdapter<JsonElement> elementAdapter = gson.getAdapter(JsonElement.class);
       final TypeAdapter<PolicyServerView> thisAdapter
                        = gson.getDelegateAdapter(this, TypeToken.get(PolicyServerView.class));

       return (TypeAdapter<T>) new TypeAdapter<PolicyServerView>() {
           @Override
           public void write(JsonWriter out, PolicyServerView value) throws IOException {
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
           public PolicyServerView read(JsonReader in) throws IOException {
             JsonElement jsonElement = elementAdapter.read(in);
             validateJsonElement(jsonElement);
             JsonObject jsonObj = jsonElement.getAsJsonObject();
             // store additional fields in the deserialized instance
             PolicyServerView instance = thisAdapter.fromJsonTree(jsonObj);
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
   * Create an instance of PolicyServerView given an JSON string
   *
   * @param jsonString JSON string
   * @return An instance of PolicyServerView
   * @throws IOException if the JSON string is invalid with respect to PolicyServerView
   */
  public static PolicyServerView fromJson(String jsonString) throws IOException {
    return JSON.getGson().fromJson(jsonString, PolicyServerView.class);
  }

  /**
   * Convert an instance of PolicyServerView to an JSON string
   *
   * @return JSON string
   */
  public String toJson() {
    return JSON.getGson().toJson(this);
  }
}
