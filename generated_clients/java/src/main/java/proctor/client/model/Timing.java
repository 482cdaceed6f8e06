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
 * Server time of this turn, in seconds.
 */
@javax.annotation.Generated(value = "org.openapitools.codegen.languages.JavaClientCodegen", comments = "Generator version: 7.26.0")
public class Timing {
  public static final String SERIALIZED_NAME_TOTAL_S = "total_s";
  @SerializedName(SERIALIZED_NAME_TOTAL_S)
  @javax.annotation.Nonnull
  private Double totalS;

  public static final String SERIALIZED_NAME_QUEUE_S = "queue_s";
  @SerializedName(SERIALIZED_NAME_QUEUE_S)
  @javax.annotation.Nonnull
  private Double queueS;

  public static final String SERIALIZED_NAME_SIMULATE_S = "simulate_s";
  @SerializedName(SERIALIZED_NAME_SIMULATE_S)
  @javax.annotation.Nonnull
  private Double simulateS;

  public static final String SERIALIZED_NAME_RENDER_S = "render_s";
  @SerializedName(SERIALIZED_NAME_RENDER_S)
  @javax.annotation.Nonnull
  private Double renderS;

  public static final String SERIALIZED_NAME_ENCODE_S = "encode_s";
  @SerializedName(SERIALIZED_NAME_ENCODE_S)
  @javax.annotation.Nonnull
  private Double encodeS;

  public Timing() {
  }

  public Timing totalS(@javax.annotation.Nonnull Double totalS) {
    this.totalS = totalS;
    return this;
  }

  /**
   * Get totalS
   * minimum: 0
   * @return totalS
   */
  @javax.annotation.Nonnull
  public Double getTotalS() {
    return totalS;
  }

  public void setTotalS(@javax.annotation.Nonnull Double totalS) {
    this.totalS = totalS;
  }


  public Timing queueS(@javax.annotation.Nonnull Double queueS) {
    this.queueS = queueS;
    return this;
  }

  /**
   * Get queueS
   * minimum: 0
   * @return queueS
   */
  @javax.annotation.Nonnull
  public Double getQueueS() {
    return queueS;
  }

  public void setQueueS(@javax.annotation.Nonnull Double queueS) {
    this.queueS = queueS;
  }


  public Timing simulateS(@javax.annotation.Nonnull Double simulateS) {
    this.simulateS = simulateS;
    return this;
  }

  /**
   * Get simulateS
   * minimum: 0
   * @return simulateS
   */
  @javax.annotation.Nonnull
  public Double getSimulateS() {
    return simulateS;
  }

  public void setSimulateS(@javax.annotation.Nonnull Double simulateS) {
    this.simulateS = simulateS;
  }


  public Timing renderS(@javax.annotation.Nonnull Double renderS) {
    this.renderS = renderS;
    return this;
  }

  /**
   * Get renderS
   * minimum: 0
   * @return renderS
   */
  @javax.annotation.Nonnull
  public Double getRenderS() {
    return renderS;
  }

  public void setRenderS(@javax.annotation.Nonnull Double renderS) {
    this.renderS = renderS;
  }


  public Timing encodeS(@javax.annotation.Nonnull Double encodeS) {
    this.encodeS = encodeS;
    return this;
  }

  /**
   * Encoding of images.
   * minimum: 0
   * @return encodeS
   */
  @javax.annotation.Nonnull
  public Double getEncodeS() {
    return encodeS;
  }

  public void setEncodeS(@javax.annotation.Nonnull Double encodeS) {
    this.encodeS = encodeS;
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
   * @return the Timing instance itself
   */
  public Timing putAdditionalProperty(String key, Object value) {
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
    Timing timing = (Timing) o;
    return Objects.equals(this.totalS, timing.totalS) &&
        Objects.equals(this.queueS, timing.queueS) &&
        Objects.equals(this.simulateS, timing.simulateS) &&
        Objects.equals(this.renderS, timing.renderS) &&
        Objects.equals(this.encodeS, timing.encodeS)&&
        Objects.equals(this.additionalProperties, timing.additionalProperties);
  }

  @Override
  public int hashCode() {
    return Objects.hash(totalS, queueS, simulateS, renderS, encodeS, additionalProperties);
  }

  @Override
  public String toString() {
    StringBuilder sb = new StringBuilder();
    sb.append("class Timing {\n");
    sb.append("    totalS: ").append(toIndentedString(totalS)).append("\n");
    sb.append("    queueS: ").append(toIndentedString(queueS)).append("\n");
    sb.append("    simulateS: ").append(toIndentedString(simulateS)).append("\n");
    sb.append("    renderS: ").append(toIndentedString(renderS)).append("\n");
    sb.append("    encodeS: ").append(toIndentedString(encodeS)).append("\n");
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
    openapiFields = new HashSet<String>(Arrays.asList("total_s", "queue_s", "simulate_s", "render_s", "encode_s"));

    // a set of required properties/fields (JSON key names)
    openapiRequiredFields = new HashSet<String>(Arrays.asList("total_s", "queue_s", "simulate_s", "render_s", "encode_s"));
  }

  /**
   * Validates the JSON Element and throws an exception if issues found
   *
   * @param jsonElement JSON Element
   * @throws IOException if the JSON Element is invalid with respect to Timing
   */
  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
      if (jsonElement == null) {
        if (!Timing.openapiRequiredFields.isEmpty()) { // has required fields but JSON element is null
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field(s) %s in Timing is not found in the empty JSON string", Timing.openapiRequiredFields.toString()));
        }
      }

      // check to make sure all required properties/fields are present in the JSON string
      for (String requiredField : Timing.openapiRequiredFields) {
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
       if (!Timing.class.isAssignableFrom(type.getRawType())) {
         return null; // this class only serializes 'Timing' and its subtypes
       }
       final TypeAdapter<JsonElement> elementAdapter = gson.getAdapter(JsonElement.class);
       final TypeAdapter<Timing> thisAdapter
                        = gson.getDelegateAdapter(this, TypeToken.get(Timing.class));

       return (TypeAdapter<T>) new TypeAdapter<Timing>() {
           @Override
           public void write(JsonWriter out, Timing value) throws IOException {
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
           public Timing read(JsonReader in) throws IOException {
             JsonElement jsonElement = elementAdapter.read(in);
             validateJsonElement(jsonElement);
             JsonObject jsonObj = jsonElement.getAsJsonObject();
             // store additional fields in the deserialized instance
             Timing instance = thisAdapter.fromJsonTree(jsonObj);
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
   * Create an instance of Timing given an JSON string
   *
   * @param jsonString JSON string
   * @return An instance of Timing
   * @throws IOException if the JSON string is invalid with respect to Timing
   */
  public static Timing fromJson(String jsonString) throws IOException {
    return JSON.getGson().fromJson(jsonString, Timing.class);
  }

  /**
   * Convert an instance of Timing to an JSON string
   *
   * @return JSON string
   */
  public String toJson() {
    return JSON.getGson().toJson(this);
  }
}
