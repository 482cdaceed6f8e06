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
import proctor.client.model.EpisodeResult;
import proctor.client.model.EpisodeStatus;

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
 * Episode
 */
@javax.annotation.Generated(value = "org.openapitools.codegen.languages.JavaClientCodegen", comments = "Generator version: 7.26.0")
public class Episode {
  public static final String SERIALIZED_NAME_EPISODE_ID = "episode_id";
  @SerializedName(SERIALIZED_NAME_EPISODE_ID)
  @javax.annotation.Nonnull
  private String episodeId;

  public static final String SERIALIZED_NAME_INDEX = "index";
  @SerializedName(SERIALIZED_NAME_INDEX)
  @javax.annotation.Nonnull
  private Integer index;

  public static final String SERIALIZED_NAME_TASK = "task";
  @SerializedName(SERIALIZED_NAME_TASK)
  @javax.annotation.Nonnull
  private String task;

  public static final String SERIALIZED_NAME_SPLIT = "split";
  @SerializedName(SERIALIZED_NAME_SPLIT)
  @javax.annotation.Nonnull
  private String split;

  public static final String SERIALIZED_NAME_STATUS = "status";
  @SerializedName(SERIALIZED_NAME_STATUS)
  @javax.annotation.Nonnull
  private EpisodeStatus status;

  public static final String SERIALIZED_NAME_ATTEMPT = "attempt";
  @SerializedName(SERIALIZED_NAME_ATTEMPT)
  @javax.annotation.Nonnull
  private Integer attempt;

  public static final String SERIALIZED_NAME_FAULTS = "faults";
  @SerializedName(SERIALIZED_NAME_FAULTS)
  @javax.annotation.Nonnull
  private Integer faults;

  public static final String SERIALIZED_NAME_POLICY_FAULT = "policy_fault";
  @SerializedName(SERIALIZED_NAME_POLICY_FAULT)
  @javax.annotation.Nullable
  private String policyFault;

  public static final String SERIALIZED_NAME_RESULT = "result";
  @SerializedName(SERIALIZED_NAME_RESULT)
  @javax.annotation.Nullable
  private EpisodeResult result;

  public Episode() {
  }

  public Episode episodeId(@javax.annotation.Nonnull String episodeId) {
    this.episodeId = episodeId;
    return this;
  }

  /**
   * Get episodeId
   * @return episodeId
   */
  @javax.annotation.Nonnull
  public String getEpisodeId() {
    return episodeId;
  }

  public void setEpisodeId(@javax.annotation.Nonnull String episodeId) {
    this.episodeId = episodeId;
  }


  public Episode index(@javax.annotation.Nonnull Integer index) {
    this.index = index;
    return this;
  }

  /**
   * Get index
   * minimum: 0
   * @return index
   */
  @javax.annotation.Nonnull
  public Integer getIndex() {
    return index;
  }

  public void setIndex(@javax.annotation.Nonnull Integer index) {
    this.index = index;
  }


  public Episode task(@javax.annotation.Nonnull String task) {
    this.task = task;
    return this;
  }

  /**
   * Get task
   * @return task
   */
  @javax.annotation.Nonnull
  public String getTask() {
    return task;
  }

  public void setTask(@javax.annotation.Nonnull String task) {
    this.task = task;
  }


  public Episode split(@javax.annotation.Nonnull String split) {
    this.split = split;
    return this;
  }

  /**
   * Get split
   * @return split
   */
  @javax.annotation.Nonnull
  public String getSplit() {
    return split;
  }

  public void setSplit(@javax.annotation.Nonnull String split) {
    this.split = split;
  }


  public Episode status(@javax.annotation.Nonnull EpisodeStatus status) {
    this.status = status;
    return this;
  }

  /**
   * Get status
   * @return status
   */
  @javax.annotation.Nonnull
  public EpisodeStatus getStatus() {
    return status;
  }

  public void setStatus(@javax.annotation.Nonnull EpisodeStatus status) {
    this.status = status;
  }


  public Episode attempt(@javax.annotation.Nonnull Integer attempt) {
    this.attempt = attempt;
    return this;
  }

  /**
   * The current or next attempt.
   * minimum: 1
   * @return attempt
   */
  @javax.annotation.Nonnull
  public Integer getAttempt() {
    return attempt;
  }

  public void setAttempt(@javax.annotation.Nonnull Integer attempt) {
    this.attempt = attempt;
  }


  public Episode faults(@javax.annotation.Nonnull Integer faults) {
    this.faults = faults;
    return this;
  }

  /**
   * Get faults
   * minimum: 0
   * @return faults
   */
  @javax.annotation.Nonnull
  public Integer getFaults() {
    return faults;
  }

  public void setFaults(@javax.annotation.Nonnull Integer faults) {
    this.faults = faults;
  }


  public Episode policyFault(@javax.annotation.Nullable String policyFault) {
    this.policyFault = policyFault;
    return this;
  }

  /**
   * In a run with mode &#x60;push&#x60;: what the policy did wrong when it last ended an attempt of this episode.
   * @return policyFault
   */
  @javax.annotation.Nullable
  public String getPolicyFault() {
    return policyFault;
  }

  public void setPolicyFault(@javax.annotation.Nullable String policyFault) {
    this.policyFault = policyFault;
  }


  public Episode result(@javax.annotation.Nullable EpisodeResult result) {
    this.result = result;
    return this;
  }

  /**
   * Get result
   * @return result
   */
  @javax.annotation.Nullable
  public EpisodeResult getResult() {
    return result;
  }

  public void setResult(@javax.annotation.Nullable EpisodeResult result) {
    this.result = result;
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
   * @return the Episode instance itself
   */
  public Episode putAdditionalProperty(String key, Object value) {
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
    Episode episode = (Episode) o;
    return Objects.equals(this.episodeId, episode.episodeId) &&
        Objects.equals(this.index, episode.index) &&
        Objects.equals(this.task, episode.task) &&
        Objects.equals(this.split, episode.split) &&
        Objects.equals(this.status, episode.status) &&
        Objects.equals(this.attempt, episode.attempt) &&
        Objects.equals(this.faults, episode.faults) &&
        Objects.equals(this.policyFault, episode.policyFault) &&
        Objects.equals(this.result, episode.result)&&
        Objects.equals(this.additionalProperties, episode.additionalProperties);
  }

  @Override
  public int hashCode() {
    return Objects.hash(episodeId, index, task, split, status, attempt, faults, policyFault, result, additionalProperties);
  }

  @Override
  public String toString() {
    StringBuilder sb = new StringBuilder();
    sb.append("class Episode {\n");
    sb.append("    episodeId: ").append(toIndentedString(episodeId)).append("\n");
    sb.append("    index: ").append(toIndentedString(index)).append("\n");
    sb.append("    task: ").append(toIndentedString(task)).append("\n");
    sb.append("    split: ").append(toIndentedString(split)).append("\n");
    sb.append("    status: ").append(toIndentedString(status)).append("\n");
    sb.append("    attempt: ").append(toIndentedString(attempt)).append("\n");
    sb.append("    faults: ").append(toIndentedString(faults)).append("\n");
    sb.append("    policyFault: ").append(toIndentedString(policyFault)).append("\n");
    sb.append("    result: ").append(toIndentedString(result)).append("\n");
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
    openapiFields = new HashSet<String>(Arrays.asList("episode_id", "index", "task", "split", "status", "attempt", "faults", "policy_fault", "result"));

    // a set of required properties/fields (JSON key names)
    openapiRequiredFields = new HashSet<String>(Arrays.asList("episode_id", "index", "task", "split", "status", "attempt", "faults"));
  }

  /**
   * Validates the JSON Element and throws an exception if issues found
   *
   * @param jsonElement JSON Element
   * @throws IOException if the JSON Element is invalid with respect to Episode
   */
  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
      if (jsonElement == null) {
        if (!Episode.openapiRequiredFields.isEmpty()) { // has required fields but JSON element is null
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field(s) %s in Episode is not found in the empty JSON string", Episode.openapiRequiredFields.toString()));
        }
      }

      // check to make sure all required properties/fields are present in the JSON string
      for (String requiredField : Episode.openapiRequiredFields) {
        if (jsonElement.getAsJsonObject().get(requiredField) == null) {
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field `%s` is not found in the JSON string: %s", requiredField, jsonElement.toString()));
        }
      }
        JsonObject jsonObj = jsonElement.getAsJsonObject();
      if (!jsonObj.get("episode_id").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `episode_id` to be a primitive type in the JSON string but got `%s`", jsonObj.get("episode_id").toString()));
      }
      if (!jsonObj.get("task").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `task` to be a primitive type in the JSON string but got `%s`", jsonObj.get("task").toString()));
      }
      if (!jsonObj.get("split").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `split` to be a primitive type in the JSON string but got `%s`", jsonObj.get("split").toString()));
      }
      // validate the required field `status`
      EpisodeStatus.validateJsonElement(jsonObj.get("status"));
      if ((jsonObj.get("policy_fault") != null && !jsonObj.get("policy_fault").isJsonNull()) && !jsonObj.get("policy_fault").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `policy_fault` to be a primitive type in the JSON string but got `%s`", jsonObj.get("policy_fault").toString()));
      }
  }

  public static class CustomTypeAdapterFactory implements TypeAdapterFactory {
    @SuppressWarnings("unchecked")
    @Override
    public <T> TypeAdapter<T> create(Gson gson, TypeToken<T> type) {
       if (!Episode.class.isAssignableFrom(type.getRawType())) {
         return null; // this class only serializes 'Episode' and its subtypes
       }
       final TypeAdapter<JsonElement> elementAdapter = gson.getAdapter(JsonElement.class);
       final TypeAdapter<Episode> thisAdapter
                        = gson.getDelegateAdapter(this, TypeToken.get(Episode.class));

       return (TypeAdapter<T>) new TypeAdapter<Episode>() {
           @Override
           public void write(JsonWriter out, Episode value) throws IOException {
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
           public Episode read(JsonReader in) throws IOException {
             JsonElement jsonElement = elementAdapter.read(in);
             validateJsonElement(jsonElement);
             JsonObject jsonObj = jsonElement.getAsJsonObject();
             // store additional fields in the deserialized instance
             Episode instance = thisAdapter.fromJsonTree(jsonObj);
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
   * Create an instance of Episode given an JSON string
   *
   * @param jsonString JSON string
   * @return An instance of Episode
   * @throws IOException if the JSON string is invalid with respect to Episode
   */
  public static Episode fromJson(String jsonString) throws IOException {
    return JSON.getGson().fromJson(jsonString, Episode.class);
  }

  /**
   * Convert an instance of Episode to an JSON string
   *
   * @return JSON string
   */
  public String toJson() {
    return JSON.getGson().toJson(this);
  }
}
