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
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import proctor.client.model.EpisodeResult;
import proctor.client.model.EpisodeView;
import proctor.client.model.Fault;
import proctor.client.model.Lease;
import proctor.client.model.Observation;
import proctor.client.model.Timing;

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
 * The answer to attach (seq 0) and to predict.
 */
@javax.annotation.Generated(value = "org.openapitools.codegen.languages.JavaClientCodegen", comments = "Generator version: 7.26.0")
public class Turn {
  public static final String SERIALIZED_NAME_SESSION_ID = "session_id";
  @SerializedName(SERIALIZED_NAME_SESSION_ID)
  @javax.annotation.Nonnull
  private String sessionId;

  public static final String SERIALIZED_NAME_SEQ = "seq";
  @SerializedName(SERIALIZED_NAME_SEQ)
  @javax.annotation.Nonnull
  private Long seq;

  public static final String SERIALIZED_NAME_EPISODE = "episode";
  @SerializedName(SERIALIZED_NAME_EPISODE)
  @javax.annotation.Nullable
  private EpisodeView episode;

  public static final String SERIALIZED_NAME_OBSERVATION = "observation";
  @SerializedName(SERIALIZED_NAME_OBSERVATION)
  @javax.annotation.Nullable
  private Observation observation;

  public static final String SERIALIZED_NAME_OBSERVATIONS = "observations";
  @SerializedName(SERIALIZED_NAME_OBSERVATIONS)
  @javax.annotation.Nullable
  private List<Observation> observations;

  public static final String SERIALIZED_NAME_EXECUTED_STEPS = "executed_steps";
  @SerializedName(SERIALIZED_NAME_EXECUTED_STEPS)
  @javax.annotation.Nonnull
  private Integer executedSteps;

  public static final String SERIALIZED_NAME_STOPPED_EARLY = "stopped_early";
  @SerializedName(SERIALIZED_NAME_STOPPED_EARLY)
  @javax.annotation.Nonnull
  private Boolean stoppedEarly;

  public static final String SERIALIZED_NAME_REWARDS = "rewards";
  @SerializedName(SERIALIZED_NAME_REWARDS)
  @javax.annotation.Nonnull
  private List<Double> rewards;

  public static final String SERIALIZED_NAME_TERMINATED = "terminated";
  @SerializedName(SERIALIZED_NAME_TERMINATED)
  @javax.annotation.Nonnull
  private Boolean terminated;

  public static final String SERIALIZED_NAME_TRUNCATED = "truncated";
  @SerializedName(SERIALIZED_NAME_TRUNCATED)
  @javax.annotation.Nonnull
  private Boolean truncated;

  public static final String SERIALIZED_NAME_EPISODE_RESULT = "episode_result";
  @SerializedName(SERIALIZED_NAME_EPISODE_RESULT)
  @javax.annotation.Nullable
  private EpisodeResult episodeResult;

  public static final String SERIALIZED_NAME_FAULT = "fault";
  @SerializedName(SERIALIZED_NAME_FAULT)
  @javax.annotation.Nullable
  private Fault fault;

  public static final String SERIALIZED_NAME_DONE = "done";
  @SerializedName(SERIALIZED_NAME_DONE)
  @javax.annotation.Nonnull
  private Boolean done;

  public static final String SERIALIZED_NAME_LEASE = "lease";
  @SerializedName(SERIALIZED_NAME_LEASE)
  @javax.annotation.Nonnull
  private Lease lease;

  public static final String SERIALIZED_NAME_TIMING = "timing";
  @SerializedName(SERIALIZED_NAME_TIMING)
  @javax.annotation.Nonnull
  private Timing timing;

  public Turn() {
  }

  public Turn sessionId(@javax.annotation.Nonnull String sessionId) {
    this.sessionId = sessionId;
    return this;
  }

  /**
   * Get sessionId
   * @return sessionId
   */
  @javax.annotation.Nonnull
  public String getSessionId() {
    return sessionId;
  }

  public void setSessionId(@javax.annotation.Nonnull String sessionId) {
    this.sessionId = sessionId;
  }


  public Turn seq(@javax.annotation.Nonnull Long seq) {
    this.seq = seq;
    return this;
  }

  /**
   * Get seq
   * minimum: 0
   * @return seq
   */
  @javax.annotation.Nonnull
  public Long getSeq() {
    return seq;
  }

  public void setSeq(@javax.annotation.Nonnull Long seq) {
    this.seq = seq;
  }


  public Turn episode(@javax.annotation.Nullable EpisodeView episode) {
    this.episode = episode;
    return this;
  }

  /**
   * Get episode
   * @return episode
   */
  @javax.annotation.Nullable
  public EpisodeView getEpisode() {
    return episode;
  }

  public void setEpisode(@javax.annotation.Nullable EpisodeView episode) {
    this.episode = episode;
  }


  public Turn observation(@javax.annotation.Nullable Observation observation) {
    this.observation = observation;
    return this;
  }

  /**
   * Get observation
   * @return observation
   */
  @javax.annotation.Nullable
  public Observation getObservation() {
    return observation;
  }

  public void setObservation(@javax.annotation.Nullable Observation observation) {
    this.observation = observation;
  }


  public Turn observations(@javax.annotation.Nullable List<Observation> observations) {
    this.observations = observations;
    return this;
  }

  public Turn addObservationsItem(Observation observationsItem) {
    if (this.observations == null) {
      this.observations = new ArrayList<>();
    }
    this.observations.add(observationsItem);
    return this;
  }

  /**
   * With &#x60;observe&#x60; all, one per executed action.
   * @return observations
   */
  @javax.annotation.Nullable
  public List<Observation> getObservations() {
    return observations;
  }

  public void setObservations(@javax.annotation.Nullable List<Observation> observations) {
    this.observations = observations;
  }


  public Turn executedSteps(@javax.annotation.Nonnull Integer executedSteps) {
    this.executedSteps = executedSteps;
    return this;
  }

  /**
   * Get executedSteps
   * minimum: 0
   * @return executedSteps
   */
  @javax.annotation.Nonnull
  public Integer getExecutedSteps() {
    return executedSteps;
  }

  public void setExecutedSteps(@javax.annotation.Nonnull Integer executedSteps) {
    this.executedSteps = executedSteps;
  }


  public Turn stoppedEarly(@javax.annotation.Nonnull Boolean stoppedEarly) {
    this.stoppedEarly = stoppedEarly;
    return this;
  }

  /**
   * The episode ended before the chunk did.
   * @return stoppedEarly
   */
  @javax.annotation.Nonnull
  public Boolean getStoppedEarly() {
    return stoppedEarly;
  }

  public void setStoppedEarly(@javax.annotation.Nonnull Boolean stoppedEarly) {
    this.stoppedEarly = stoppedEarly;
  }


  public Turn rewards(@javax.annotation.Nonnull List<Double> rewards) {
    this.rewards = rewards;
    return this;
  }

  public Turn addRewardsItem(Double rewardsItem) {
    if (this.rewards == null) {
      this.rewards = new ArrayList<>();
    }
    this.rewards.add(rewardsItem);
    return this;
  }

  /**
   * One per executed action.
   * @return rewards
   */
  @javax.annotation.Nonnull
  public List<Double> getRewards() {
    return rewards;
  }

  public void setRewards(@javax.annotation.Nonnull List<Double> rewards) {
    this.rewards = rewards;
  }


  public Turn terminated(@javax.annotation.Nonnull Boolean terminated) {
    this.terminated = terminated;
    return this;
  }

  /**
   * The task ended by itself in this turn.
   * @return terminated
   */
  @javax.annotation.Nonnull
  public Boolean getTerminated() {
    return terminated;
  }

  public void setTerminated(@javax.annotation.Nonnull Boolean terminated) {
    this.terminated = terminated;
  }


  public Turn truncated(@javax.annotation.Nonnull Boolean truncated) {
    this.truncated = truncated;
    return this;
  }

  /**
   * The step limit ended the episode in this turn.
   * @return truncated
   */
  @javax.annotation.Nonnull
  public Boolean getTruncated() {
    return truncated;
  }

  public void setTruncated(@javax.annotation.Nonnull Boolean truncated) {
    this.truncated = truncated;
  }


  public Turn episodeResult(@javax.annotation.Nullable EpisodeResult episodeResult) {
    this.episodeResult = episodeResult;
    return this;
  }

  /**
   * Get episodeResult
   * @return episodeResult
   */
  @javax.annotation.Nullable
  public EpisodeResult getEpisodeResult() {
    return episodeResult;
  }

  public void setEpisodeResult(@javax.annotation.Nullable EpisodeResult episodeResult) {
    this.episodeResult = episodeResult;
  }


  public Turn fault(@javax.annotation.Nullable Fault fault) {
    this.fault = fault;
    return this;
  }

  /**
   * Get fault
   * @return fault
   */
  @javax.annotation.Nullable
  public Fault getFault() {
    return fault;
  }

  public void setFault(@javax.annotation.Nullable Fault fault) {
    this.fault = fault;
  }


  public Turn done(@javax.annotation.Nonnull Boolean done) {
    this.done = done;
    return this;
  }

  /**
   * No episode is left for this session. It holds no slot any more; its last turn can be repeated until its lease ends.
   * @return done
   */
  @javax.annotation.Nonnull
  public Boolean getDone() {
    return done;
  }

  public void setDone(@javax.annotation.Nonnull Boolean done) {
    this.done = done;
  }


  public Turn lease(@javax.annotation.Nonnull Lease lease) {
    this.lease = lease;
    return this;
  }

  /**
   * Get lease
   * @return lease
   */
  @javax.annotation.Nonnull
  public Lease getLease() {
    return lease;
  }

  public void setLease(@javax.annotation.Nonnull Lease lease) {
    this.lease = lease;
  }


  public Turn timing(@javax.annotation.Nonnull Timing timing) {
    this.timing = timing;
    return this;
  }

  /**
   * Get timing
   * @return timing
   */
  @javax.annotation.Nonnull
  public Timing getTiming() {
    return timing;
  }

  public void setTiming(@javax.annotation.Nonnull Timing timing) {
    this.timing = timing;
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
   * @return the Turn instance itself
   */
  public Turn putAdditionalProperty(String key, Object value) {
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
    Turn turn = (Turn) o;
    return Objects.equals(this.sessionId, turn.sessionId) &&
        Objects.equals(this.seq, turn.seq) &&
        Objects.equals(this.episode, turn.episode) &&
        Objects.equals(this.observation, turn.observation) &&
        Objects.equals(this.observations, turn.observations) &&
        Objects.equals(this.executedSteps, turn.executedSteps) &&
        Objects.equals(this.stoppedEarly, turn.stoppedEarly) &&
        Objects.equals(this.rewards, turn.rewards) &&
        Objects.equals(this.terminated, turn.terminated) &&
        Objects.equals(this.truncated, turn.truncated) &&
        Objects.equals(this.episodeResult, turn.episodeResult) &&
        Objects.equals(this.fault, turn.fault) &&
        Objects.equals(this.done, turn.done) &&
        Objects.equals(this.lease, turn.lease) &&
        Objects.equals(this.timing, turn.timing)&&
        Objects.equals(this.additionalProperties, turn.additionalProperties);
  }

  @Override
  public int hashCode() {
    return Objects.hash(sessionId, seq, episode, observation, observations, executedSteps, stoppedEarly, rewards, terminated, truncated, episodeResult, fault, done, lease, timing, additionalProperties);
  }

  @Override
  public String toString() {
    StringBuilder sb = new StringBuilder();
    sb.append("class Turn {\n");
    sb.append("    sessionId: ").append(toIndentedString(sessionId)).append("\n");
    sb.append("    seq: ").append(toIndentedString(seq)).append("\n");
    sb.append("    episode: ").append(toIndentedString(episode)).append("\n");
    sb.append("    observation: ").append(toIndentedString(observation)).append("\n");
    sb.append("    observations: ").append(toIndentedString(observations)).append("\n");
    sb.append("    executedSteps: ").append(toIndentedString(executedSteps)).append("\n");
    sb.append("    stoppedEarly: ").append(toIndentedString(stoppedEarly)).append("\n");
    sb.append("    rewards: ").append(toIndentedString(rewards)).append("\n");
    sb.append("    terminated: ").append(toIndentedString(terminated)).append("\n");
    sb.append("    truncated: ").append(toIndentedString(truncated)).append("\n");
    sb.append("    episodeResult: ").append(toIndentedString(episodeResult)).append("\n");
    sb.append("    fault: ").append(toIndentedString(fault)).append("\n");
    sb.append("    done: ").append(toIndentedString(done)).append("\n");
    sb.append("    lease: ").append(toIndentedString(lease)).append("\n");
    sb.append("    timing: ").append(toIndentedString(timing)).append("\n");
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
    openapiFields = new HashSet<String>(Arrays.asList("session_id", "seq", "episode", "observation", "observations", "executed_steps", "stopped_early", "rewards", "terminated", "truncated", "episode_result", "fault", "done", "lease", "timing"));

    // a set of required properties/fields (JSON key names)
    openapiRequiredFields = new HashSet<String>(Arrays.asList("session_id", "seq", "executed_steps", "stopped_early", "rewards", "terminated", "truncated", "done", "lease", "timing"));
  }

  /**
   * Validates the JSON Element and throws an exception if issues found
   *
   * @param jsonElement JSON Element
   * @throws IOException if the JSON Element is invalid with respect to Turn
   */
  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
      if (jsonElement == null) {
        if (!Turn.openapiRequiredFields.isEmpty()) { // has required fields but JSON element is null
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field(s) %s in Turn is not found in the empty JSON string", Turn.openapiRequiredFields.toString()));
        }
      }

      // check to make sure all required properties/fields are present in the JSON string
      for (String requiredField : Turn.openapiRequiredFields) {
        if (jsonElement.getAsJsonObject().get(requiredField) == null) {
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field `%s` is not found in the JSON string: %s", requiredField, jsonElement.toString()));
        }
      }
        JsonObject jsonObj = jsonElement.getAsJsonObject();
      if (!jsonObj.get("session_id").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `session_id` to be a primitive type in the JSON string but got `%s`", jsonObj.get("session_id").toString()));
      }
      // ensure the optional json data is an array if present
      if (jsonObj.get("observations") != null && !jsonObj.get("observations").isJsonNull() && !jsonObj.get("observations").isJsonArray()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `observations` to be an array in the JSON string but got `%s`", jsonObj.get("observations").toString()));
      }
      // ensure the required json array is present
      if (jsonObj.get("rewards") == null) {
        throw new IllegalArgumentException("Expected the field `linkedContent` to be an array in the JSON string but got `null`");
      } else if (!jsonObj.get("rewards").isJsonArray()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `rewards` to be an array in the JSON string but got `%s`", jsonObj.get("rewards").toString()));
      }
  }

  public static class CustomTypeAdapterFactory implements TypeAdapterFactory {
    @SuppressWarnings("unchecked")
    @Override
    public <T> TypeAdapter<T> create(Gson gson, TypeToken<T> type) {
       if (!Turn.class.isAssignableFrom(type.getRawType())) {
         return null; // this class only serializes 'Turn' and its subtypes
       }
       final TypeAdapter<JsonElement> elementAdapter = gson.getAdapter(JsonElement.class);
       final TypeAdapter<Turn> thisAdapter
                        = gson.getDelegateAdapter(this, TypeToken.get(Turn.class));

       return (TypeAdapter<T>) new TypeAdapter<Turn>() {
           @Override
           public void write(JsonWriter out, Turn value) throws IOException {
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
           public Turn read(JsonReader in) throws IOException {
             JsonElement jsonElement = elementAdapter.read(in);
             validateJsonElement(jsonElement);
             JsonObject jsonObj = jsonElement.getAsJsonObject();
             // store additional fields in the deserialized instance
             Turn instance = thisAdapter.fromJsonTree(jsonObj);
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
   * Create an instance of Turn given an JSON string
   *
   * @param jsonString JSON string
   * @return An instance of Turn
   * @throws IOException if the JSON string is invalid with respect to Turn
   */
  public static Turn fromJson(String jsonString) throws IOException {
    return JSON.getGson().fromJson(jsonString, Turn.class);
  }

  /**
   * Convert an instance of Turn to an JSON string
   *
   * @return JSON string
   */
  public String toJson() {
    return JSON.getGson().toJson(this);
  }
}
