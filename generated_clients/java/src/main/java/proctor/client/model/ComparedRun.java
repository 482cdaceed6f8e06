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
import proctor.client.model.ComparedTask;

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
 * One run beside the baseline. A pair is an episode that both have scored.
 */
@javax.annotation.Generated(value = "org.openapitools.codegen.languages.JavaClientCodegen", comments = "Generator version: 7.26.0")
public class ComparedRun {
  public static final String SERIALIZED_NAME_RUN_ID = "run_id";
  @SerializedName(SERIALIZED_NAME_RUN_ID)
  @javax.annotation.Nonnull
  private String runId;

  public static final String SERIALIZED_NAME_COMPLETE = "complete";
  @SerializedName(SERIALIZED_NAME_COMPLETE)
  @javax.annotation.Nonnull
  private Boolean complete;

  public static final String SERIALIZED_NAME_RELEASE = "release";
  @SerializedName(SERIALIZED_NAME_RELEASE)
  @javax.annotation.Nonnull
  private Boolean release;

  public static final String SERIALIZED_NAME_PAIRED = "paired";
  @SerializedName(SERIALIZED_NAME_PAIRED)
  @javax.annotation.Nonnull
  private Integer paired;

  public static final String SERIALIZED_NAME_BASELINE_MEAN = "baseline_mean";
  @SerializedName(SERIALIZED_NAME_BASELINE_MEAN)
  @javax.annotation.Nullable
  private Double baselineMean;

  public static final String SERIALIZED_NAME_MEAN = "mean";
  @SerializedName(SERIALIZED_NAME_MEAN)
  @javax.annotation.Nullable
  private Double mean;

  public static final String SERIALIZED_NAME_DIFFERENCE = "difference";
  @SerializedName(SERIALIZED_NAME_DIFFERENCE)
  @javax.annotation.Nullable
  private Double difference;

  public static final String SERIALIZED_NAME_WINS = "wins";
  @SerializedName(SERIALIZED_NAME_WINS)
  @javax.annotation.Nonnull
  private Integer wins;

  public static final String SERIALIZED_NAME_LOSSES = "losses";
  @SerializedName(SERIALIZED_NAME_LOSSES)
  @javax.annotation.Nonnull
  private Integer losses;

  public static final String SERIALIZED_NAME_TIES = "ties";
  @SerializedName(SERIALIZED_NAME_TIES)
  @javax.annotation.Nonnull
  private Integer ties;

  public static final String SERIALIZED_NAME_P_VALUE = "p_value";
  @SerializedName(SERIALIZED_NAME_P_VALUE)
  @javax.annotation.Nonnull
  private Double pValue;

  public static final String SERIALIZED_NAME_BY_TASK = "by_task";
  @SerializedName(SERIALIZED_NAME_BY_TASK)
  @javax.annotation.Nonnull
  private Map<String, ComparedTask> byTask;

  public ComparedRun() {
  }

  public ComparedRun runId(@javax.annotation.Nonnull String runId) {
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


  public ComparedRun complete(@javax.annotation.Nonnull Boolean complete) {
    this.complete = complete;
    return this;
  }

  /**
   * Both runs have scored every episode.
   * @return complete
   */
  @javax.annotation.Nonnull
  public Boolean getComplete() {
    return complete;
  }

  public void setComplete(@javax.annotation.Nonnull Boolean complete) {
    this.complete = complete;
  }


  public ComparedRun release(@javax.annotation.Nonnull Boolean release) {
    this.release = release;
    return this;
  }

  /**
   * Complete, and no difference, over all episodes or over those of a task, is beyond the tolerance.
   * @return release
   */
  @javax.annotation.Nonnull
  public Boolean getRelease() {
    return release;
  }

  public void setRelease(@javax.annotation.Nonnull Boolean release) {
    this.release = release;
  }


  public ComparedRun paired(@javax.annotation.Nonnull Integer paired) {
    this.paired = paired;
    return this;
  }

  /**
   * Number of pairs.
   * minimum: 0
   * @return paired
   */
  @javax.annotation.Nonnull
  public Integer getPaired() {
    return paired;
  }

  public void setPaired(@javax.annotation.Nonnull Integer paired) {
    this.paired = paired;
  }


  public ComparedRun baselineMean(@javax.annotation.Nullable Double baselineMean) {
    this.baselineMean = baselineMean;
    return this;
  }

  /**
   * Mean score of the baseline over the pairs.
   * @return baselineMean
   */
  @javax.annotation.Nullable
  public Double getBaselineMean() {
    return baselineMean;
  }

  public void setBaselineMean(@javax.annotation.Nullable Double baselineMean) {
    this.baselineMean = baselineMean;
  }


  public ComparedRun mean(@javax.annotation.Nullable Double mean) {
    this.mean = mean;
    return this;
  }

  /**
   * Mean score of the run over the pairs.
   * @return mean
   */
  @javax.annotation.Nullable
  public Double getMean() {
    return mean;
  }

  public void setMean(@javax.annotation.Nullable Double mean) {
    this.mean = mean;
  }


  public ComparedRun difference(@javax.annotation.Nullable Double difference) {
    this.difference = difference;
    return this;
  }

  /**
   * Baseline minus run: positive when the run is worse.
   * @return difference
   */
  @javax.annotation.Nullable
  public Double getDifference() {
    return difference;
  }

  public void setDifference(@javax.annotation.Nullable Double difference) {
    this.difference = difference;
  }


  public ComparedRun wins(@javax.annotation.Nonnull Integer wins) {
    this.wins = wins;
    return this;
  }

  /**
   * Pairs in which the run alone succeeds.
   * minimum: 0
   * @return wins
   */
  @javax.annotation.Nonnull
  public Integer getWins() {
    return wins;
  }

  public void setWins(@javax.annotation.Nonnull Integer wins) {
    this.wins = wins;
  }


  public ComparedRun losses(@javax.annotation.Nonnull Integer losses) {
    this.losses = losses;
    return this;
  }

  /**
   * Pairs in which the baseline alone succeeds.
   * minimum: 0
   * @return losses
   */
  @javax.annotation.Nonnull
  public Integer getLosses() {
    return losses;
  }

  public void setLosses(@javax.annotation.Nonnull Integer losses) {
    this.losses = losses;
  }


  public ComparedRun ties(@javax.annotation.Nonnull Integer ties) {
    this.ties = ties;
    return this;
  }

  /**
   * Pairs in which both succeed or neither does.
   * minimum: 0
   * @return ties
   */
  @javax.annotation.Nonnull
  public Integer getTies() {
    return ties;
  }

  public void setTies(@javax.annotation.Nonnull Integer ties) {
    this.ties = ties;
  }


  public ComparedRun pValue(@javax.annotation.Nonnull Double pValue) {
    this.pValue = pValue;
    return this;
  }

  /**
   * McNemar&#39;s exact test, two-sided.
   * minimum: 0
   * maximum: 1
   * @return pValue
   */
  @javax.annotation.Nonnull
  public Double getpValue() {
    return pValue;
  }

  public void setpValue(@javax.annotation.Nonnull Double pValue) {
    this.pValue = pValue;
  }


  public ComparedRun byTask(@javax.annotation.Nonnull Map<String, ComparedTask> byTask) {
    this.byTask = byTask;
    return this;
  }

  public ComparedRun putByTaskItem(String key, ComparedTask byTaskItem) {
    if (this.byTask == null) {
      this.byTask = new HashMap<>();
    }
    this.byTask.put(key, byTaskItem);
    return this;
  }

  /**
   * Task → the pairs of its episodes.
   * @return byTask
   */
  @javax.annotation.Nonnull
  public Map<String, ComparedTask> getByTask() {
    return byTask;
  }

  public void setByTask(@javax.annotation.Nonnull Map<String, ComparedTask> byTask) {
    this.byTask = byTask;
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
   * @return the ComparedRun instance itself
   */
  public ComparedRun putAdditionalProperty(String key, Object value) {
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
    ComparedRun comparedRun = (ComparedRun) o;
    return Objects.equals(this.runId, comparedRun.runId) &&
        Objects.equals(this.complete, comparedRun.complete) &&
        Objects.equals(this.release, comparedRun.release) &&
        Objects.equals(this.paired, comparedRun.paired) &&
        Objects.equals(this.baselineMean, comparedRun.baselineMean) &&
        Objects.equals(this.mean, comparedRun.mean) &&
        Objects.equals(this.difference, comparedRun.difference) &&
        Objects.equals(this.wins, comparedRun.wins) &&
        Objects.equals(this.losses, comparedRun.losses) &&
        Objects.equals(this.ties, comparedRun.ties) &&
        Objects.equals(this.pValue, comparedRun.pValue) &&
        Objects.equals(this.byTask, comparedRun.byTask)&&
        Objects.equals(this.additionalProperties, comparedRun.additionalProperties);
  }

  @Override
  public int hashCode() {
    return Objects.hash(runId, complete, release, paired, baselineMean, mean, difference, wins, losses, ties, pValue, byTask, additionalProperties);
  }

  @Override
  public String toString() {
    StringBuilder sb = new StringBuilder();
    sb.append("class ComparedRun {\n");
    sb.append("    runId: ").append(toIndentedString(runId)).append("\n");
    sb.append("    complete: ").append(toIndentedString(complete)).append("\n");
    sb.append("    release: ").append(toIndentedString(release)).append("\n");
    sb.append("    paired: ").append(toIndentedString(paired)).append("\n");
    sb.append("    baselineMean: ").append(toIndentedString(baselineMean)).append("\n");
    sb.append("    mean: ").append(toIndentedString(mean)).append("\n");
    sb.append("    difference: ").append(toIndentedString(difference)).append("\n");
    sb.append("    wins: ").append(toIndentedString(wins)).append("\n");
    sb.append("    losses: ").append(toIndentedString(losses)).append("\n");
    sb.append("    ties: ").append(toIndentedString(ties)).append("\n");
    sb.append("    pValue: ").append(toIndentedString(pValue)).append("\n");
    sb.append("    byTask: ").append(toIndentedString(byTask)).append("\n");
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
    openapiFields = new HashSet<String>(Arrays.asList("run_id", "complete", "release", "paired", "baseline_mean", "mean", "difference", "wins", "losses", "ties", "p_value", "by_task"));

    // a set of required properties/fields (JSON key names)
    openapiRequiredFields = new HashSet<String>(Arrays.asList("run_id", "complete", "release", "paired", "baseline_mean", "mean", "difference", "wins", "losses", "ties", "p_value", "by_task"));
  }

  /**
   * Validates the JSON Element and throws an exception if issues found
   *
   * @param jsonElement JSON Element
   * @throws IOException if the JSON Element is invalid with respect to ComparedRun
   */
  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
      if (jsonElement == null) {
        if (!ComparedRun.openapiRequiredFields.isEmpty()) { // has required fields but JSON element is null
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field(s) %s in ComparedRun is not found in the empty JSON string", ComparedRun.openapiRequiredFields.toString()));
        }
      }

      // check to make sure all required properties/fields are present in the JSON string
      for (String requiredField : ComparedRun.openapiRequiredFields) {
        if (jsonElement.getAsJsonObject().get(requiredField) == null) {
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field `%s` is not found in the JSON string: %s", requiredField, jsonElement.toString()));
        }
      }
        JsonObject jsonObj = jsonElement.getAsJsonObject();
      if (!jsonObj.get("run_id").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `run_id` to be a primitive type in the JSON string but got `%s`", jsonObj.get("run_id").toString()));
      }
  }

  public static class CustomTypeAdapterFactory implements TypeAdapterFactory {
    @SuppressWarnings("unchecked")
    @Override
    public <T> TypeAdapter<T> create(Gson gson, TypeToken<T> type) {
       if (!ComparedRun.class.isAssignableFrom(type.getRawType())) {
         return null; // this class only serializes 'ComparedRun' and its subtypes
       }
       final TypeAdapter<JsonElement> elementAdapter = gson.getAdapter(JsonElement.class);
       final TypeAdapter<ComparedRun> thisAdapter
                        = gson.getDelegateAdapter(this, TypeToken.get(ComparedRun.class));

       return (TypeAdapter<T>) new TypeAdapter<ComparedRun>() {
           @Override
           public void write(JsonWriter out, ComparedRun value) throws IOException {
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
           public ComparedRun read(JsonReader in) throws IOException {
             JsonElement jsonElement = elementAdapter.read(in);
             validateJsonElement(jsonElement);
             JsonObject jsonObj = jsonElement.getAsJsonObject();
             // store additional fields in the deserialized instance
             ComparedRun instance = thisAdapter.fromJsonTree(jsonObj);
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
   * Create an instance of ComparedRun given an JSON string
   *
   * @param jsonString JSON string
   * @return An instance of ComparedRun
   * @throws IOException if the JSON string is invalid with respect to ComparedRun
   */
  public static ComparedRun fromJson(String jsonString) throws IOException {
    return JSON.getGson().fromJson(jsonString, ComparedRun.class);
  }

  /**
   * Convert an instance of ComparedRun to an JSON string
   *
   * @return JSON string
   */
  public String toJson() {
    return JSON.getGson().toJson(this);
  }
}
