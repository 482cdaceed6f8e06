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
import proctor.client.model.GroupScore;
import proctor.client.model.Interval;
import proctor.client.model.OutcomeCounts;
import proctor.client.model.RunState;

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
 * See scoring.md for every number here.
 */
@javax.annotation.Generated(value = "org.openapitools.codegen.languages.JavaClientCodegen", comments = "Generator version: 7.26.0")
public class Score {
  public static final String SERIALIZED_NAME_RUN_ID = "run_id";
  @SerializedName(SERIALIZED_NAME_RUN_ID)
  @javax.annotation.Nonnull
  private String runId;

  public static final String SERIALIZED_NAME_BENCHMARK_ID = "benchmark_id";
  @SerializedName(SERIALIZED_NAME_BENCHMARK_ID)
  @javax.annotation.Nonnull
  private String benchmarkId;

  public static final String SERIALIZED_NAME_MANIFEST_SHA256 = "manifest_sha256";
  @SerializedName(SERIALIZED_NAME_MANIFEST_SHA256)
  @javax.annotation.Nonnull
  private String manifestSha256;

  public static final String SERIALIZED_NAME_STATE = "state";
  @SerializedName(SERIALIZED_NAME_STATE)
  @javax.annotation.Nonnull
  private RunState state;

  public static final String SERIALIZED_NAME_COMPLETE = "complete";
  @SerializedName(SERIALIZED_NAME_COMPLETE)
  @javax.annotation.Nonnull
  private Boolean complete;

  public static final String SERIALIZED_NAME_SCORE = "score";
  @SerializedName(SERIALIZED_NAME_SCORE)
  @javax.annotation.Nullable
  private Double score;

  public static final String SERIALIZED_NAME_SCORE_LOW = "score_low";
  @SerializedName(SERIALIZED_NAME_SCORE_LOW)
  @javax.annotation.Nonnull
  private Double scoreLow;

  public static final String SERIALIZED_NAME_SCORE_HIGH = "score_high";
  @SerializedName(SERIALIZED_NAME_SCORE_HIGH)
  @javax.annotation.Nonnull
  private Double scoreHigh;

  public static final String SERIALIZED_NAME_COUNTS = "counts";
  @SerializedName(SERIALIZED_NAME_COUNTS)
  @javax.annotation.Nonnull
  private OutcomeCounts counts;

  public static final String SERIALIZED_NAME_SUCCESS_RATE = "success_rate";
  @SerializedName(SERIALIZED_NAME_SUCCESS_RATE)
  @javax.annotation.Nullable
  private Double successRate;

  public static final String SERIALIZED_NAME_SUCCESS_INTERVAL = "success_interval";
  @SerializedName(SERIALIZED_NAME_SUCCESS_INTERVAL)
  @javax.annotation.Nonnull
  private Interval successInterval;

  public static final String SERIALIZED_NAME_MEAN = "mean";
  @SerializedName(SERIALIZED_NAME_MEAN)
  @javax.annotation.Nullable
  private Double mean;

  public static final String SERIALIZED_NAME_MEAN_INTERVAL = "mean_interval";
  @SerializedName(SERIALIZED_NAME_MEAN_INTERVAL)
  @javax.annotation.Nonnull
  private Interval meanInterval;

  public static final String SERIALIZED_NAME_BY_TASK = "by_task";
  @SerializedName(SERIALIZED_NAME_BY_TASK)
  @javax.annotation.Nonnull
  private Map<String, GroupScore> byTask;

  public static final String SERIALIZED_NAME_BY_SPLIT = "by_split";
  @SerializedName(SERIALIZED_NAME_BY_SPLIT)
  @javax.annotation.Nonnull
  private Map<String, GroupScore> bySplit;

  public Score() {
  }

  public Score runId(@javax.annotation.Nonnull String runId) {
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


  public Score benchmarkId(@javax.annotation.Nonnull String benchmarkId) {
    this.benchmarkId = benchmarkId;
    return this;
  }

  /**
   * Get benchmarkId
   * @return benchmarkId
   */
  @javax.annotation.Nonnull
  public String getBenchmarkId() {
    return benchmarkId;
  }

  public void setBenchmarkId(@javax.annotation.Nonnull String benchmarkId) {
    this.benchmarkId = benchmarkId;
  }


  public Score manifestSha256(@javax.annotation.Nonnull String manifestSha256) {
    this.manifestSha256 = manifestSha256;
    return this;
  }

  /**
   * The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
   * @return manifestSha256
   */
  @javax.annotation.Nonnull
  public String getManifestSha256() {
    return manifestSha256;
  }

  public void setManifestSha256(@javax.annotation.Nonnull String manifestSha256) {
    this.manifestSha256 = manifestSha256;
  }


  public Score state(@javax.annotation.Nonnull RunState state) {
    this.state = state;
    return this;
  }

  /**
   * Get state
   * @return state
   */
  @javax.annotation.Nonnull
  public RunState getState() {
    return state;
  }

  public void setState(@javax.annotation.Nonnull RunState state) {
    this.state = state;
  }


  public Score complete(@javax.annotation.Nonnull Boolean complete) {
    this.complete = complete;
    return this;
  }

  /**
   * Get complete
   * @return complete
   */
  @javax.annotation.Nonnull
  public Boolean getComplete() {
    return complete;
  }

  public void setComplete(@javax.annotation.Nonnull Boolean complete) {
    this.complete = complete;
  }


  public Score score(@javax.annotation.Nullable Double score) {
    this.score = score;
    return this;
  }

  /**
   * Null until complete.
   * @return score
   */
  @javax.annotation.Nullable
  public Double getScore() {
    return score;
  }

  public void setScore(@javax.annotation.Nullable Double score) {
    this.score = score;
  }


  public Score scoreLow(@javax.annotation.Nonnull Double scoreLow) {
    this.scoreLow = scoreLow;
    return this;
  }

  /**
   * Get scoreLow
   * @return scoreLow
   */
  @javax.annotation.Nonnull
  public Double getScoreLow() {
    return scoreLow;
  }

  public void setScoreLow(@javax.annotation.Nonnull Double scoreLow) {
    this.scoreLow = scoreLow;
  }


  public Score scoreHigh(@javax.annotation.Nonnull Double scoreHigh) {
    this.scoreHigh = scoreHigh;
    return this;
  }

  /**
   * Get scoreHigh
   * @return scoreHigh
   */
  @javax.annotation.Nonnull
  public Double getScoreHigh() {
    return scoreHigh;
  }

  public void setScoreHigh(@javax.annotation.Nonnull Double scoreHigh) {
    this.scoreHigh = scoreHigh;
  }


  public Score counts(@javax.annotation.Nonnull OutcomeCounts counts) {
    this.counts = counts;
    return this;
  }

  /**
   * Get counts
   * @return counts
   */
  @javax.annotation.Nonnull
  public OutcomeCounts getCounts() {
    return counts;
  }

  public void setCounts(@javax.annotation.Nonnull OutcomeCounts counts) {
    this.counts = counts;
  }


  public Score successRate(@javax.annotation.Nullable Double successRate) {
    this.successRate = successRate;
    return this;
  }

  /**
   * Get successRate
   * @return successRate
   */
  @javax.annotation.Nullable
  public Double getSuccessRate() {
    return successRate;
  }

  public void setSuccessRate(@javax.annotation.Nullable Double successRate) {
    this.successRate = successRate;
  }


  public Score successInterval(@javax.annotation.Nonnull Interval successInterval) {
    this.successInterval = successInterval;
    return this;
  }

  /**
   * Get successInterval
   * @return successInterval
   */
  @javax.annotation.Nonnull
  public Interval getSuccessInterval() {
    return successInterval;
  }

  public void setSuccessInterval(@javax.annotation.Nonnull Interval successInterval) {
    this.successInterval = successInterval;
  }


  public Score mean(@javax.annotation.Nullable Double mean) {
    this.mean = mean;
    return this;
  }

  /**
   * Mean over the scored episodes.
   * @return mean
   */
  @javax.annotation.Nullable
  public Double getMean() {
    return mean;
  }

  public void setMean(@javax.annotation.Nullable Double mean) {
    this.mean = mean;
  }


  public Score meanInterval(@javax.annotation.Nonnull Interval meanInterval) {
    this.meanInterval = meanInterval;
    return this;
  }

  /**
   * Get meanInterval
   * @return meanInterval
   */
  @javax.annotation.Nonnull
  public Interval getMeanInterval() {
    return meanInterval;
  }

  public void setMeanInterval(@javax.annotation.Nonnull Interval meanInterval) {
    this.meanInterval = meanInterval;
  }


  public Score byTask(@javax.annotation.Nonnull Map<String, GroupScore> byTask) {
    this.byTask = byTask;
    return this;
  }

  public Score putByTaskItem(String key, GroupScore byTaskItem) {
    if (this.byTask == null) {
      this.byTask = new HashMap<>();
    }
    this.byTask.put(key, byTaskItem);
    return this;
  }

  /**
   * Get byTask
   * @return byTask
   */
  @javax.annotation.Nonnull
  public Map<String, GroupScore> getByTask() {
    return byTask;
  }

  public void setByTask(@javax.annotation.Nonnull Map<String, GroupScore> byTask) {
    this.byTask = byTask;
  }


  public Score bySplit(@javax.annotation.Nonnull Map<String, GroupScore> bySplit) {
    this.bySplit = bySplit;
    return this;
  }

  public Score putBySplitItem(String key, GroupScore bySplitItem) {
    if (this.bySplit == null) {
      this.bySplit = new HashMap<>();
    }
    this.bySplit.put(key, bySplitItem);
    return this;
  }

  /**
   * Get bySplit
   * @return bySplit
   */
  @javax.annotation.Nonnull
  public Map<String, GroupScore> getBySplit() {
    return bySplit;
  }

  public void setBySplit(@javax.annotation.Nonnull Map<String, GroupScore> bySplit) {
    this.bySplit = bySplit;
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
   * @return the Score instance itself
   */
  public Score putAdditionalProperty(String key, Object value) {
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
    Score score = (Score) o;
    return Objects.equals(this.runId, score.runId) &&
        Objects.equals(this.benchmarkId, score.benchmarkId) &&
        Objects.equals(this.manifestSha256, score.manifestSha256) &&
        Objects.equals(this.state, score.state) &&
        Objects.equals(this.complete, score.complete) &&
        Objects.equals(this.score, score.score) &&
        Objects.equals(this.scoreLow, score.scoreLow) &&
        Objects.equals(this.scoreHigh, score.scoreHigh) &&
        Objects.equals(this.counts, score.counts) &&
        Objects.equals(this.successRate, score.successRate) &&
        Objects.equals(this.successInterval, score.successInterval) &&
        Objects.equals(this.mean, score.mean) &&
        Objects.equals(this.meanInterval, score.meanInterval) &&
        Objects.equals(this.byTask, score.byTask) &&
        Objects.equals(this.bySplit, score.bySplit)&&
        Objects.equals(this.additionalProperties, score.additionalProperties);
  }

  @Override
  public int hashCode() {
    return Objects.hash(runId, benchmarkId, manifestSha256, state, complete, score, scoreLow, scoreHigh, counts, successRate, successInterval, mean, meanInterval, byTask, bySplit, additionalProperties);
  }

  @Override
  public String toString() {
    StringBuilder sb = new StringBuilder();
    sb.append("class Score {\n");
    sb.append("    runId: ").append(toIndentedString(runId)).append("\n");
    sb.append("    benchmarkId: ").append(toIndentedString(benchmarkId)).append("\n");
    sb.append("    manifestSha256: ").append(toIndentedString(manifestSha256)).append("\n");
    sb.append("    state: ").append(toIndentedString(state)).append("\n");
    sb.append("    complete: ").append(toIndentedString(complete)).append("\n");
    sb.append("    score: ").append(toIndentedString(score)).append("\n");
    sb.append("    scoreLow: ").append(toIndentedString(scoreLow)).append("\n");
    sb.append("    scoreHigh: ").append(toIndentedString(scoreHigh)).append("\n");
    sb.append("    counts: ").append(toIndentedString(counts)).append("\n");
    sb.append("    successRate: ").append(toIndentedString(successRate)).append("\n");
    sb.append("    successInterval: ").append(toIndentedString(successInterval)).append("\n");
    sb.append("    mean: ").append(toIndentedString(mean)).append("\n");
    sb.append("    meanInterval: ").append(toIndentedString(meanInterval)).append("\n");
    sb.append("    byTask: ").append(toIndentedString(byTask)).append("\n");
    sb.append("    bySplit: ").append(toIndentedString(bySplit)).append("\n");
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
    openapiFields = new HashSet<String>(Arrays.asList("run_id", "benchmark_id", "manifest_sha256", "state", "complete", "score", "score_low", "score_high", "counts", "success_rate", "success_interval", "mean", "mean_interval", "by_task", "by_split"));

    // a set of required properties/fields (JSON key names)
    openapiRequiredFields = new HashSet<String>(Arrays.asList("run_id", "benchmark_id", "manifest_sha256", "state", "complete", "score", "score_low", "score_high", "counts", "success_rate", "success_interval", "mean", "mean_interval", "by_task", "by_split"));
  }

  /**
   * Validates the JSON Element and throws an exception if issues found
   *
   * @param jsonElement JSON Element
   * @throws IOException if the JSON Element is invalid with respect to Score
   */
  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
      if (jsonElement == null) {
        if (!Score.openapiRequiredFields.isEmpty()) { // has required fields but JSON element is null
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field(s) %s in Score is not found in the empty JSON string", Score.openapiRequiredFields.toString()));
        }
      }

      // check to make sure all required properties/fields are present in the JSON string
      for (String requiredField : Score.openapiRequiredFields) {
        if (jsonElement.getAsJsonObject().get(requiredField) == null) {
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field `%s` is not found in the JSON string: %s", requiredField, jsonElement.toString()));
        }
      }
        JsonObject jsonObj = jsonElement.getAsJsonObject();
      if (!jsonObj.get("run_id").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `run_id` to be a primitive type in the JSON string but got `%s`", jsonObj.get("run_id").toString()));
      }
      if (!jsonObj.get("benchmark_id").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `benchmark_id` to be a primitive type in the JSON string but got `%s`", jsonObj.get("benchmark_id").toString()));
      }
      if (!jsonObj.get("manifest_sha256").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `manifest_sha256` to be a primitive type in the JSON string but got `%s`", jsonObj.get("manifest_sha256").toString()));
      }
      // validate the required field `state`
      RunState.validateJsonElement(jsonObj.get("state"));
  }

  public static class CustomTypeAdapterFactory implements TypeAdapterFactory {
    @SuppressWarnings("unchecked")
    @Override
    public <T> TypeAdapter<T> create(Gson gson, TypeToken<T> type) {
       if (!Score.class.isAssignableFrom(type.getRawType())) {
         return null; // this class only serializes 'Score' and its subtypes
       }
       final TypeAdapter<JsonElement> elementAdapter = gson.getAdapter(JsonElement.class);
       final TypeAdapter<Score> thisAdapter
                        = gson.getDelegateAdapter(this, TypeToken.get(Score.class));

       return (TypeAdapter<T>) new TypeAdapter<Score>() {
           @Override
           public void write(JsonWriter out, Score value) throws IOException {
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
           public Score read(JsonReader in) throws IOException {
             JsonElement jsonElement = elementAdapter.read(in);
             validateJsonElement(jsonElement);
             JsonObject jsonObj = jsonElement.getAsJsonObject();
             // store additional fields in the deserialized instance
             Score instance = thisAdapter.fromJsonTree(jsonObj);
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
   * Create an instance of Score given an JSON string
   *
   * @param jsonString JSON string
   * @return An instance of Score
   * @throws IOException if the JSON string is invalid with respect to Score
   */
  public static Score fromJson(String jsonString) throws IOException {
    return JSON.getGson().fromJson(jsonString, Score.class);
  }

  /**
   * Convert an instance of Score to an JSON string
   *
   * @return JSON string
   */
  public String toJson() {
    return JSON.getGson().toJson(this);
  }
}
