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
import proctor.client.model.Assumptions;

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
 * AttachWorker
 */
@javax.annotation.Generated(value = "org.openapitools.codegen.languages.JavaClientCodegen", comments = "Generator version: 7.26.0")
public class AttachWorker {
  public static final String SERIALIZED_NAME_ATTACH_KEY = "attach_key";
  @SerializedName(SERIALIZED_NAME_ATTACH_KEY)
  @javax.annotation.Nonnull
  private String attachKey;

  public static final String SERIALIZED_NAME_TAKEOVER = "takeover";
  @SerializedName(SERIALIZED_NAME_TAKEOVER)
  @javax.annotation.Nullable
  private Boolean takeover;

  public static final String SERIALIZED_NAME_ASSUMES = "assumes";
  @SerializedName(SERIALIZED_NAME_ASSUMES)
  @javax.annotation.Nullable
  private Assumptions assumes;

  public AttachWorker() {
  }

  public AttachWorker attachKey(@javax.annotation.Nonnull String attachKey) {
    this.attachKey = attachKey;
    return this;
  }

  /**
   * Chosen anew for every attachment; repeated only to repeat a lost request.
   * @return attachKey
   */
  @javax.annotation.Nonnull
  public String getAttachKey() {
    return attachKey;
  }

  public void setAttachKey(@javax.annotation.Nonnull String attachKey) {
    this.attachKey = attachKey;
  }


  public AttachWorker takeover(@javax.annotation.Nullable Boolean takeover) {
    this.takeover = takeover;
    return this;
  }

  /**
   * Fence out a live session; false when absent.
   * @return takeover
   */
  @javax.annotation.Nullable
  public Boolean getTakeover() {
    return takeover;
  }

  public void setTakeover(@javax.annotation.Nullable Boolean takeover) {
    this.takeover = takeover;
  }


  public AttachWorker assumes(@javax.annotation.Nullable Assumptions assumes) {
    this.assumes = assumes;
    return this;
  }

  /**
   * Get assumes
   * @return assumes
   */
  @javax.annotation.Nullable
  public Assumptions getAssumes() {
    return assumes;
  }

  public void setAssumes(@javax.annotation.Nullable Assumptions assumes) {
    this.assumes = assumes;
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
   * @return the AttachWorker instance itself
   */
  public AttachWorker putAdditionalProperty(String key, Object value) {
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
    AttachWorker attachWorker = (AttachWorker) o;
    return Objects.equals(this.attachKey, attachWorker.attachKey) &&
        Objects.equals(this.takeover, attachWorker.takeover) &&
        Objects.equals(this.assumes, attachWorker.assumes)&&
        Objects.equals(this.additionalProperties, attachWorker.additionalProperties);
  }

  @Override
  public int hashCode() {
    return Objects.hash(attachKey, takeover, assumes, additionalProperties);
  }

  @Override
  public String toString() {
    StringBuilder sb = new StringBuilder();
    sb.append("class AttachWorker {\n");
    sb.append("    attachKey: ").append(toIndentedString(attachKey)).append("\n");
    sb.append("    takeover: ").append(toIndentedString(takeover)).append("\n");
    sb.append("    assumes: ").append(toIndentedString(assumes)).append("\n");
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
    openapiFields = new HashSet<String>(Arrays.asList("attach_key", "takeover", "assumes"));

    // a set of required properties/fields (JSON key names)
    openapiRequiredFields = new HashSet<String>(Arrays.asList("attach_key"));
  }

  /**
   * Validates the JSON Element and throws an exception if issues found
   *
   * @param jsonElement JSON Element
   * @throws IOException if the JSON Element is invalid with respect to AttachWorker
   */
  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
      if (jsonElement == null) {
        if (!AttachWorker.openapiRequiredFields.isEmpty()) { // has required fields but JSON element is null
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field(s) %s in AttachWorker is not found in the empty JSON string", AttachWorker.openapiRequiredFields.toString()));
        }
      }

      // check to make sure all required properties/fields are present in the JSON string
      for (String requiredField : AttachWorker.openapiRequiredFields) {
        if (jsonElement.getAsJsonObject().get(requiredField) == null) {
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field `%s` is not found in the JSON string: %s", requiredField, jsonElement.toString()));
        }
      }
        JsonObject jsonObj = jsonElement.getAsJsonObject();
      if (!jsonObj.get("attach_key").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `attach_key` to be a primitive type in the JSON string but got `%s`", jsonObj.get("attach_key").toString()));
      }
      // validate the optional field `assumes`
      if (jsonObj.get("assumes") != null && !jsonObj.get("assumes").isJsonNull()) {
        Assumptions.validateJsonElement(jsonObj.get("assumes"));
      }
  }

  public static class CustomTypeAdapterFactory implements TypeAdapterFactory {
    @SuppressWarnings("unchecked")
    @Override
    public <T> TypeAdapter<T> create(Gson gson, TypeToken<T> type) {
       if (!AttachWorker.class.isAssignableFrom(type.getRawType())) {
         return null; // this class only serializes 'AttachWorker' and its subtypes
       }
       final TypeAdapter<JsonElement> elementAdapter = gson.getAdapter(JsonElement.class);
       final TypeAdapter<AttachWorker> thisAdapter
                        = gson.getDelegateAdapter(this, TypeToken.get(AttachWorker.class));

       return (TypeAdapter<T>) new TypeAdapter<AttachWorker>() {
           @Override
           public void write(JsonWriter out, AttachWorker value) throws IOException {
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
           public AttachWorker read(JsonReader in) throws IOException {
             JsonElement jsonElement = elementAdapter.read(in);
             validateJsonElement(jsonElement);
             JsonObject jsonObj = jsonElement.getAsJsonObject();
             // store additional fields in the deserialized instance
             AttachWorker instance = thisAdapter.fromJsonTree(jsonObj);
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
   * Create an instance of AttachWorker given an JSON string
   *
   * @param jsonString JSON string
   * @return An instance of AttachWorker
   * @throws IOException if the JSON string is invalid with respect to AttachWorker
   */
  public static AttachWorker fromJson(String jsonString) throws IOException {
    return JSON.getGson().fromJson(jsonString, AttachWorker.class);
  }

  /**
   * Convert an instance of AttachWorker to an JSON string
   *
   * @return JSON string
   */
  public String toJson() {
    return JSON.getGson().toJson(this);
  }
}
