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
import proctor.client.model.Outcome;

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
 * EpisodeResult
 */
@javax.annotation.Generated(value = "org.openapitools.codegen.languages.JavaClientCodegen", comments = "Generator version: 7.26.0")
public class EpisodeResult {
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

  public static final String SERIALIZED_NAME_SEED = "seed";
  @SerializedName(SERIALIZED_NAME_SEED)
  @javax.annotation.Nonnull
  private Long seed;

  public static final String SERIALIZED_NAME_ATTEMPT = "attempt";
  @SerializedName(SERIALIZED_NAME_ATTEMPT)
  @javax.annotation.Nonnull
  private Integer attempt;

  public static final String SERIALIZED_NAME_FAULTS = "faults";
  @SerializedName(SERIALIZED_NAME_FAULTS)
  @javax.annotation.Nonnull
  private Integer faults;

  public static final String SERIALIZED_NAME_OUTCOME = "outcome";
  @SerializedName(SERIALIZED_NAME_OUTCOME)
  @javax.annotation.Nonnull
  private Outcome outcome;

  public static final String SERIALIZED_NAME_SCORE = "score";
  @SerializedName(SERIALIZED_NAME_SCORE)
  @javax.annotation.Nonnull
  private Double score;

  public static final String SERIALIZED_NAME_STEPS = "steps";
  @SerializedName(SERIALIZED_NAME_STEPS)
  @javax.annotation.Nonnull
  private Integer steps;

  public static final String SERIALIZED_NAME_TERMINATED = "terminated";
  @SerializedName(SERIALIZED_NAME_TERMINATED)
  @javax.annotation.Nonnull
  private Boolean terminated;

  public static final String SERIALIZED_NAME_TRUNCATED = "truncated";
  @SerializedName(SERIALIZED_NAME_TRUNCATED)
  @javax.annotation.Nonnull
  private Boolean truncated;

  public static final String SERIALIZED_NAME_THINK_S = "think_s";
  @SerializedName(SERIALIZED_NAME_THINK_S)
  @javax.annotation.Nonnull
  private Double thinkS;

  public static final String SERIALIZED_NAME_FINISHED_AT = "finished_at";
  @SerializedName(SERIALIZED_NAME_FINISHED_AT)
  @javax.annotation.Nonnull
  private OffsetDateTime finishedAt;

  public EpisodeResult() {
  }

  public EpisodeResult episodeId(@javax.annotation.Nonnull String episodeId) {
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


  public EpisodeResult index(@javax.annotation.Nonnull Integer index) {
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


  public EpisodeResult task(@javax.annotation.Nonnull String task) {
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


  public EpisodeResult split(@javax.annotation.Nonnull String split) {
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


  public EpisodeResult seed(@javax.annotation.Nonnull Long seed) {
    this.seed = seed;
    return this;
  }

  /**
   * Get seed
   * minimum: 0
   * maximum: 9007199254740991
   * @return seed
   */
  @javax.annotation.Nonnull
  public Long getSeed() {
    return seed;
  }

  public void setSeed(@javax.annotation.Nonnull Long seed) {
    this.seed = seed;
  }


  public EpisodeResult attempt(@javax.annotation.Nonnull Integer attempt) {
    this.attempt = attempt;
    return this;
  }

  /**
   * Get attempt
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


  public EpisodeResult faults(@javax.annotation.Nonnull Integer faults) {
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


  public EpisodeResult outcome(@javax.annotation.Nonnull Outcome outcome) {
    this.outcome = outcome;
    return this;
  }

  /**
   * Get outcome
   * @return outcome
   */
  @javax.annotation.Nonnull
  public Outcome getOutcome() {
    return outcome;
  }

  public void setOutcome(@javax.annotation.Nonnull Outcome outcome) {
    this.outcome = outcome;
  }


  public EpisodeResult score(@javax.annotation.Nonnull Double score) {
    this.score = score;
    return this;
  }

  /**
   * Get score
   * minimum: 0
   * maximum: 1
   * @return score
   */
  @javax.annotation.Nonnull
  public Double getScore() {
    return score;
  }

  public void setScore(@javax.annotation.Nonnull Double score) {
    this.score = score;
  }


  public EpisodeResult steps(@javax.annotation.Nonnull Integer steps) {
    this.steps = steps;
    return this;
  }

  /**
   * Get steps
   * minimum: 0
   * @return steps
   */
  @javax.annotation.Nonnull
  public Integer getSteps() {
    return steps;
  }

  public void setSteps(@javax.annotation.Nonnull Integer steps) {
    this.steps = steps;
  }


  public EpisodeResult terminated(@javax.annotation.Nonnull Boolean terminated) {
    this.terminated = terminated;
    return this;
  }

  /**
   * Get terminated
   * @return terminated
   */
  @javax.annotation.Nonnull
  public Boolean getTerminated() {
    return terminated;
  }

  public void setTerminated(@javax.annotation.Nonnull Boolean terminated) {
    this.terminated = terminated;
  }


  public EpisodeResult truncated(@javax.annotation.Nonnull Boolean truncated) {
    this.truncated = truncated;
    return this;
  }

  /**
   * Get truncated
   * @return truncated
   */
  @javax.annotation.Nonnull
  public Boolean getTruncated() {
    return truncated;
  }

  public void setTruncated(@javax.annotation.Nonnull Boolean truncated) {
    this.truncated = truncated;
  }


  public EpisodeResult thinkS(@javax.annotation.Nonnull Double thinkS) {
    this.thinkS = thinkS;
    return this;
  }

  /**
   * Time between turns that the policy took.
   * minimum: 0
   * @return thinkS
   */
  @javax.annotation.Nonnull
  public Double getThinkS() {
    return thinkS;
  }

  public void setThinkS(@javax.annotation.Nonnull Double thinkS) {
    this.thinkS = thinkS;
  }


  public EpisodeResult finishedAt(@javax.annotation.Nonnull OffsetDateTime finishedAt) {
    this.finishedAt = finishedAt;
    return this;
  }

  /**
   * Get finishedAt
   * @return finishedAt
   */
  @javax.annotation.Nonnull
  public OffsetDateTime getFinishedAt() {
    return finishedAt;
  }

  public void setFinishedAt(@javax.annotation.Nonnull OffsetDateTime finishedAt) {
    this.finishedAt = finishedAt;
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
   * @return the EpisodeResult instance itself
   */
  public EpisodeResult putAdditionalProperty(String key, Object value) {
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
    EpisodeResult episodeResult = (EpisodeResult) o;
    return Objects.equals(this.episodeId, episodeResult.episodeId) &&
        Objects.equals(this.index, episodeResult.index) &&
        Objects.equals(this.task, episodeResult.task) &&
        Objects.equals(this.split, episodeResult.split) &&
        Objects.equals(this.seed, episodeResult.seed) &&
        Objects.equals(this.attempt, episodeResult.attempt) &&
        Objects.equals(this.faults, episodeResult.faults) &&
        Objects.equals(this.outcome, episodeResult.outcome) &&
        Objects.equals(this.score, episodeResult.score) &&
        Objects.equals(this.steps, episodeResult.steps) &&
        Objects.equals(this.terminated, episodeResult.terminated) &&
        Objects.equals(this.truncated, episodeResult.truncated) &&
        Objects.equals(this.thinkS, episodeResult.thinkS) &&
        Objects.equals(this.finishedAt, episodeResult.finishedAt)&&
        Objects.equals(this.additionalProperties, episodeResult.additionalProperties);
  }

  @Override
  public int hashCode() {
    return Objects.hash(episodeId, index, task, split, seed, attempt, faults, outcome, score, steps, terminated, truncated, thinkS, finishedAt, additionalProperties);
  }

  @Override
  public String toString() {
    StringBuilder sb = new StringBuilder();
    sb.append("class EpisodeResult {\n");
    sb.append("    episodeId: ").append(toIndentedString(episodeId)).append("\n");
    sb.append("    index: ").append(toIndentedString(index)).append("\n");
    sb.append("    task: ").append(toIndentedString(task)).append("\n");
    sb.append("    split: ").append(toIndentedString(split)).append("\n");
    sb.append("    seed: ").append(toIndentedString(seed)).append("\n");
    sb.append("    attempt: ").append(toIndentedString(attempt)).append("\n");
    sb.append("    faults: ").append(toIndentedString(faults)).append("\n");
    sb.append("    outcome: ").append(toIndentedString(outcome)).append("\n");
    sb.append("    score: ").append(toIndentedString(score)).append("\n");
    sb.append("    steps: ").append(toIndentedString(steps)).append("\n");
    sb.append("    terminated: ").append(toIndentedString(terminated)).append("\n");
    sb.append("    truncated: ").append(toIndentedString(truncated)).append("\n");
    sb.append("    thinkS: ").append(toIndentedString(thinkS)).append("\n");
    sb.append("    finishedAt: ").append(toIndentedString(finishedAt)).append("\n");
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
    openapiFields = new HashSet<String>(Arrays.asList("episode_id", "index", "task", "split", "seed", "attempt", "faults", "outcome", "score", "steps", "terminated", "truncated", "think_s", "finished_at"));

    // a set of required properties/fields (JSON key names)
    openapiRequiredFields = new HashSet<String>(Arrays.asList("episode_id", "index", "task", "split", "seed", "attempt", "faults", "outcome", "score", "steps", "terminated", "truncated", "think_s", "finished_at"));
  }

  /**
   * Validates the JSON Element and throws an exception if issues found
   *
   * @param jsonElement JSON Element
   * @throws IOException if the JSON Element is invalid with respect to EpisodeResult
   */
  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
      if (jsonElement == null) {
        if (!EpisodeResult.openapiRequiredFields.isEmpty()) { // has required fields but JSON element is null
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field(s) %s in EpisodeResult is not found in the empty JSON string", EpisodeResult.openapiRequiredFields.toString()));
        }
      }

      // check to make sure all required properties/fields are present in the JSON string
      for (String requiredField : EpisodeResult.openapiRequiredFields) {
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
      // validate the required field `outcome`
      Outcome.validateJsonElement(jsonObj.get("outcome"));
  }

  public static class CustomTypeAdapterFactory implements TypeAdapterFactory {
    @SuppressWarnings("unchecked")
    @Override
    public <T> TypeAdapter<T> create(Gson gson, TypeToken<T> type) {
       if (!EpisodeResult.class.isAssignableFrom(type.getRawType())) {
         return null; // this class only serializes 'EpisodeResult' and its subtypes
       }
       final TypeAdapter<JsonElement> elementAdapter = gson.getAdapter(JsonElement.class);
       final TypeAdapter<EpisodeResult> thisAdapter
                        = gson.getDelegateAdapter(this, TypeToken.get(EpisodeResult.class));

       return (TypeAdapter<T>) new TypeAdapter<EpisodeResult>() {
           @Override
           public void write(JsonWriter out, EpisodeResult value) throws IOException {
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
           public EpisodeResult read(JsonReader in) throws IOException {
             JsonElement jsonElement = elementAdapter.read(in);
             validateJsonElement(jsonElement);
             JsonObject jsonObj = jsonElement.getAsJsonObject();
             // store additional fields in the deserialized instance
             EpisodeResult instance = thisAdapter.fromJsonTree(jsonObj);
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
   * Create an instance of EpisodeResult given an JSON string
   *
   * @param jsonString JSON string
   * @return An instance of EpisodeResult
   * @throws IOException if the JSON string is invalid with respect to EpisodeResult
   */
  public static EpisodeResult fromJson(String jsonString) throws IOException {
    return JSON.getGson().fromJson(jsonString, EpisodeResult.class);
  }

  /**
   * Convert an instance of EpisodeResult to an JSON string
   *
   * @return JSON string
   */
  public String toJson() {
    return JSON.getGson().toJson(this);
  }
}
