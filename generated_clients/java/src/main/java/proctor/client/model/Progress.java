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
 * Progress
 */
@javax.annotation.Generated(value = "org.openapitools.codegen.languages.JavaClientCodegen", comments = "Generator version: 7.26.0")
public class Progress {
  public static final String SERIALIZED_NAME_EPISODES_TOTAL = "episodes_total";
  @SerializedName(SERIALIZED_NAME_EPISODES_TOTAL)
  @javax.annotation.Nonnull
  private Integer episodesTotal;

  public static final String SERIALIZED_NAME_EPISODES_SCORED = "episodes_scored";
  @SerializedName(SERIALIZED_NAME_EPISODES_SCORED)
  @javax.annotation.Nonnull
  private Integer episodesScored;

  public static final String SERIALIZED_NAME_EPISODES_IN_PROGRESS = "episodes_in_progress";
  @SerializedName(SERIALIZED_NAME_EPISODES_IN_PROGRESS)
  @javax.annotation.Nonnull
  private Integer episodesInProgress;

  public static final String SERIALIZED_NAME_EPISODES_PENDING = "episodes_pending";
  @SerializedName(SERIALIZED_NAME_EPISODES_PENDING)
  @javax.annotation.Nonnull
  private Integer episodesPending;

  public Progress() {
  }

  public Progress episodesTotal(@javax.annotation.Nonnull Integer episodesTotal) {
    this.episodesTotal = episodesTotal;
    return this;
  }

  /**
   * Get episodesTotal
   * @return episodesTotal
   */
  @javax.annotation.Nonnull
  public Integer getEpisodesTotal() {
    return episodesTotal;
  }

  public void setEpisodesTotal(@javax.annotation.Nonnull Integer episodesTotal) {
    this.episodesTotal = episodesTotal;
  }


  public Progress episodesScored(@javax.annotation.Nonnull Integer episodesScored) {
    this.episodesScored = episodesScored;
    return this;
  }

  /**
   * Abandoned ones included.
   * @return episodesScored
   */
  @javax.annotation.Nonnull
  public Integer getEpisodesScored() {
    return episodesScored;
  }

  public void setEpisodesScored(@javax.annotation.Nonnull Integer episodesScored) {
    this.episodesScored = episodesScored;
  }


  public Progress episodesInProgress(@javax.annotation.Nonnull Integer episodesInProgress) {
    this.episodesInProgress = episodesInProgress;
    return this;
  }

  /**
   * Get episodesInProgress
   * @return episodesInProgress
   */
  @javax.annotation.Nonnull
  public Integer getEpisodesInProgress() {
    return episodesInProgress;
  }

  public void setEpisodesInProgress(@javax.annotation.Nonnull Integer episodesInProgress) {
    this.episodesInProgress = episodesInProgress;
  }


  public Progress episodesPending(@javax.annotation.Nonnull Integer episodesPending) {
    this.episodesPending = episodesPending;
    return this;
  }

  /**
   * Get episodesPending
   * @return episodesPending
   */
  @javax.annotation.Nonnull
  public Integer getEpisodesPending() {
    return episodesPending;
  }

  public void setEpisodesPending(@javax.annotation.Nonnull Integer episodesPending) {
    this.episodesPending = episodesPending;
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
   * @return the Progress instance itself
   */
  public Progress putAdditionalProperty(String key, Object value) {
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
    Progress progress = (Progress) o;
    return Objects.equals(this.episodesTotal, progress.episodesTotal) &&
        Objects.equals(this.episodesScored, progress.episodesScored) &&
        Objects.equals(this.episodesInProgress, progress.episodesInProgress) &&
        Objects.equals(this.episodesPending, progress.episodesPending)&&
        Objects.equals(this.additionalProperties, progress.additionalProperties);
  }

  @Override
  public int hashCode() {
    return Objects.hash(episodesTotal, episodesScored, episodesInProgress, episodesPending, additionalProperties);
  }

  @Override
  public String toString() {
    StringBuilder sb = new StringBuilder();
    sb.append("class Progress {\n");
    sb.append("    episodesTotal: ").append(toIndentedString(episodesTotal)).append("\n");
    sb.append("    episodesScored: ").append(toIndentedString(episodesScored)).append("\n");
    sb.append("    episodesInProgress: ").append(toIndentedString(episodesInProgress)).append("\n");
    sb.append("    episodesPending: ").append(toIndentedString(episodesPending)).append("\n");
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
    openapiFields = new HashSet<String>(Arrays.asList("episodes_total", "episodes_scored", "episodes_in_progress", "episodes_pending"));

    // a set of required properties/fields (JSON key names)
    openapiRequiredFields = new HashSet<String>(Arrays.asList("episodes_total", "episodes_scored", "episodes_in_progress", "episodes_pending"));
  }

  /**
   * Validates the JSON Element and throws an exception if issues found
   *
   * @param jsonElement JSON Element
   * @throws IOException if the JSON Element is invalid with respect to Progress
   */
  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
      if (jsonElement == null) {
        if (!Progress.openapiRequiredFields.isEmpty()) { // has required fields but JSON element is null
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field(s) %s in Progress is not found in the empty JSON string", Progress.openapiRequiredFields.toString()));
        }
      }

      // check to make sure all required properties/fields are present in the JSON string
      for (String requiredField : Progress.openapiRequiredFields) {
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
       if (!Progress.class.isAssignableFrom(type.getRawType())) {
         return null; // this class only serializes 'Progress' and its subtypes
       }
       final TypeAdapter<JsonElement> elementAdapter = gson.getAdapter(JsonElement.class);
       final TypeAdapter<Progress> thisAdapter
                        = gson.getDelegateAdapter(this, TypeToken.get(Progress.class));

       return (TypeAdapter<T>) new TypeAdapter<Progress>() {
           @Override
           public void write(JsonWriter out, Progress value) throws IOException {
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
           public Progress read(JsonReader in) throws IOException {
             JsonElement jsonElement = elementAdapter.read(in);
             validateJsonElement(jsonElement);
             JsonObject jsonObj = jsonElement.getAsJsonObject();
             // store additional fields in the deserialized instance
             Progress instance = thisAdapter.fromJsonTree(jsonObj);
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
   * Create an instance of Progress given an JSON string
   *
   * @param jsonString JSON string
   * @return An instance of Progress
   * @throws IOException if the JSON string is invalid with respect to Progress
   */
  public static Progress fromJson(String jsonString) throws IOException {
    return JSON.getGson().fromJson(jsonString, Progress.class);
  }

  /**
   * Convert an instance of Progress to an JSON string
   *
   * @return JSON string
   */
  public String toJson() {
    return JSON.getGson().toJson(this);
  }
}
