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
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import proctor.client.model.ImageSize;
import proctor.client.model.ObservationSpace;
import proctor.client.model.SimulatorInfo;
import proctor.client.model.VectorSpace;

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
 * Everything about a benchmark that can change a score.
 */
@javax.annotation.Generated(value = "org.openapitools.codegen.languages.JavaClientCodegen", comments = "Generator version: 7.26.0")
public class Benchmark {
  public static final String SERIALIZED_NAME_BENCHMARK_ID = "benchmark_id";
  @SerializedName(SERIALIZED_NAME_BENCHMARK_ID)
  @javax.annotation.Nonnull
  private String benchmarkId;

  public static final String SERIALIZED_NAME_VERSION = "version";
  @SerializedName(SERIALIZED_NAME_VERSION)
  @javax.annotation.Nonnull
  private String version;

  public static final String SERIALIZED_NAME_TITLE = "title";
  @SerializedName(SERIALIZED_NAME_TITLE)
  @javax.annotation.Nonnull
  private String title;

  public static final String SERIALIZED_NAME_DESCRIPTION = "description";
  @SerializedName(SERIALIZED_NAME_DESCRIPTION)
  @javax.annotation.Nonnull
  private String description;

  public static final String SERIALIZED_NAME_MANIFEST_SHA256 = "manifest_sha256";
  @SerializedName(SERIALIZED_NAME_MANIFEST_SHA256)
  @javax.annotation.Nonnull
  private String manifestSha256;

  public static final String SERIALIZED_NAME_EPISODES_TOTAL = "episodes_total";
  @SerializedName(SERIALIZED_NAME_EPISODES_TOTAL)
  @javax.annotation.Nonnull
  private Integer episodesTotal;

  public static final String SERIALIZED_NAME_TASKS = "tasks";
  @SerializedName(SERIALIZED_NAME_TASKS)
  @javax.annotation.Nonnull
  private List<String> tasks;

  public static final String SERIALIZED_NAME_SPLITS = "splits";
  @SerializedName(SERIALIZED_NAME_SPLITS)
  @javax.annotation.Nonnull
  private List<String> splits;

  public static final String SERIALIZED_NAME_CONTROL_RATE_HZ = "control_rate_hz";
  @SerializedName(SERIALIZED_NAME_CONTROL_RATE_HZ)
  @javax.annotation.Nonnull
  private Double controlRateHz;

  public static final String SERIALIZED_NAME_MAX_STEPS = "max_steps";
  @SerializedName(SERIALIZED_NAME_MAX_STEPS)
  @javax.annotation.Nonnull
  private Integer maxSteps;

  public static final String SERIALIZED_NAME_MAX_CHUNK = "max_chunk";
  @SerializedName(SERIALIZED_NAME_MAX_CHUNK)
  @javax.annotation.Nonnull
  private Integer maxChunk;

  public static final String SERIALIZED_NAME_MAX_ATTEMPTS = "max_attempts";
  @SerializedName(SERIALIZED_NAME_MAX_ATTEMPTS)
  @javax.annotation.Nonnull
  private Integer maxAttempts;

  public static final String SERIALIZED_NAME_MAX_FAULTS = "max_faults";
  @SerializedName(SERIALIZED_NAME_MAX_FAULTS)
  @javax.annotation.Nonnull
  private Integer maxFaults;

  public static final String SERIALIZED_NAME_SUCCESS_RULE = "success_rule";
  @SerializedName(SERIALIZED_NAME_SUCCESS_RULE)
  @javax.annotation.Nonnull
  private String successRule;

  public static final String SERIALIZED_NAME_ACTION_SPACE = "action_space";
  @SerializedName(SERIALIZED_NAME_ACTION_SPACE)
  @javax.annotation.Nonnull
  private Map<String, VectorSpace> actionSpace;

  public static final String SERIALIZED_NAME_OBSERVATION_SPACE = "observation_space";
  @SerializedName(SERIALIZED_NAME_OBSERVATION_SPACE)
  @javax.annotation.Nonnull
  private ObservationSpace observationSpace;

  public static final String SERIALIZED_NAME_IMAGE_SIZES = "image_sizes";
  @SerializedName(SERIALIZED_NAME_IMAGE_SIZES)
  @javax.annotation.Nonnull
  private List<ImageSize> imageSizes;

  public static final String SERIALIZED_NAME_IMAGE_CODECS = "image_codecs";
  @SerializedName(SERIALIZED_NAME_IMAGE_CODECS)
  @javax.annotation.Nonnull
  private List<String> imageCodecs;

  public static final String SERIALIZED_NAME_SIMULATOR = "simulator";
  @SerializedName(SERIALIZED_NAME_SIMULATOR)
  @javax.annotation.Nonnull
  private SimulatorInfo simulator;

  public static final String SERIALIZED_NAME_UNAVAILABLE_REASON = "unavailable_reason";
  @SerializedName(SERIALIZED_NAME_UNAVAILABLE_REASON)
  @javax.annotation.Nullable
  private String unavailableReason;

  public Benchmark() {
  }

  public Benchmark benchmarkId(@javax.annotation.Nonnull String benchmarkId) {
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


  public Benchmark version(@javax.annotation.Nonnull String version) {
    this.version = version;
    return this;
  }

  /**
   * Get version
   * @return version
   */
  @javax.annotation.Nonnull
  public String getVersion() {
    return version;
  }

  public void setVersion(@javax.annotation.Nonnull String version) {
    this.version = version;
  }


  public Benchmark title(@javax.annotation.Nonnull String title) {
    this.title = title;
    return this;
  }

  /**
   * Get title
   * @return title
   */
  @javax.annotation.Nonnull
  public String getTitle() {
    return title;
  }

  public void setTitle(@javax.annotation.Nonnull String title) {
    this.title = title;
  }


  public Benchmark description(@javax.annotation.Nonnull String description) {
    this.description = description;
    return this;
  }

  /**
   * Get description
   * @return description
   */
  @javax.annotation.Nonnull
  public String getDescription() {
    return description;
  }

  public void setDescription(@javax.annotation.Nonnull String description) {
    this.description = description;
  }


  public Benchmark manifestSha256(@javax.annotation.Nonnull String manifestSha256) {
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


  public Benchmark episodesTotal(@javax.annotation.Nonnull Integer episodesTotal) {
    this.episodesTotal = episodesTotal;
    return this;
  }

  /**
   * Get episodesTotal
   * minimum: 1
   * @return episodesTotal
   */
  @javax.annotation.Nonnull
  public Integer getEpisodesTotal() {
    return episodesTotal;
  }

  public void setEpisodesTotal(@javax.annotation.Nonnull Integer episodesTotal) {
    this.episodesTotal = episodesTotal;
  }


  public Benchmark tasks(@javax.annotation.Nonnull List<String> tasks) {
    this.tasks = tasks;
    return this;
  }

  public Benchmark addTasksItem(String tasksItem) {
    if (this.tasks == null) {
      this.tasks = new ArrayList<>();
    }
    this.tasks.add(tasksItem);
    return this;
  }

  /**
   * Get tasks
   * @return tasks
   */
  @javax.annotation.Nonnull
  public List<String> getTasks() {
    return tasks;
  }

  public void setTasks(@javax.annotation.Nonnull List<String> tasks) {
    this.tasks = tasks;
  }


  public Benchmark splits(@javax.annotation.Nonnull List<String> splits) {
    this.splits = splits;
    return this;
  }

  public Benchmark addSplitsItem(String splitsItem) {
    if (this.splits == null) {
      this.splits = new ArrayList<>();
    }
    this.splits.add(splitsItem);
    return this;
  }

  /**
   * Get splits
   * @return splits
   */
  @javax.annotation.Nonnull
  public List<String> getSplits() {
    return splits;
  }

  public void setSplits(@javax.annotation.Nonnull List<String> splits) {
    this.splits = splits;
  }


  public Benchmark controlRateHz(@javax.annotation.Nonnull Double controlRateHz) {
    this.controlRateHz = controlRateHz;
    return this;
  }

  /**
   * Actions per simulated second.
   * @return controlRateHz
   */
  @javax.annotation.Nonnull
  public Double getControlRateHz() {
    return controlRateHz;
  }

  public void setControlRateHz(@javax.annotation.Nonnull Double controlRateHz) {
    this.controlRateHz = controlRateHz;
  }


  public Benchmark maxSteps(@javax.annotation.Nonnull Integer maxSteps) {
    this.maxSteps = maxSteps;
    return this;
  }

  /**
   * Steps after which an episode is truncated.
   * minimum: 1
   * @return maxSteps
   */
  @javax.annotation.Nonnull
  public Integer getMaxSteps() {
    return maxSteps;
  }

  public void setMaxSteps(@javax.annotation.Nonnull Integer maxSteps) {
    this.maxSteps = maxSteps;
  }


  public Benchmark maxChunk(@javax.annotation.Nonnull Integer maxChunk) {
    this.maxChunk = maxChunk;
    return this;
  }

  /**
   * Get maxChunk
   * minimum: 1
   * @return maxChunk
   */
  @javax.annotation.Nonnull
  public Integer getMaxChunk() {
    return maxChunk;
  }

  public void setMaxChunk(@javax.annotation.Nonnull Integer maxChunk) {
    this.maxChunk = maxChunk;
  }


  public Benchmark maxAttempts(@javax.annotation.Nonnull Integer maxAttempts) {
    this.maxAttempts = maxAttempts;
    return this;
  }

  /**
   * Get maxAttempts
   * minimum: 1
   * @return maxAttempts
   */
  @javax.annotation.Nonnull
  public Integer getMaxAttempts() {
    return maxAttempts;
  }

  public void setMaxAttempts(@javax.annotation.Nonnull Integer maxAttempts) {
    this.maxAttempts = maxAttempts;
  }


  public Benchmark maxFaults(@javax.annotation.Nonnull Integer maxFaults) {
    this.maxFaults = maxFaults;
    return this;
  }

  /**
   * Get maxFaults
   * minimum: 1
   * @return maxFaults
   */
  @javax.annotation.Nonnull
  public Integer getMaxFaults() {
    return maxFaults;
  }

  public void setMaxFaults(@javax.annotation.Nonnull Integer maxFaults) {
    this.maxFaults = maxFaults;
  }


  public Benchmark successRule(@javax.annotation.Nonnull String successRule) {
    this.successRule = successRule;
    return this;
  }

  /**
   * A &#x60;SuccessRule&#x60;, or one of a later version.
   * @return successRule
   */
  @javax.annotation.Nonnull
  public String getSuccessRule() {
    return successRule;
  }

  public void setSuccessRule(@javax.annotation.Nonnull String successRule) {
    this.successRule = successRule;
  }


  public Benchmark actionSpace(@javax.annotation.Nonnull Map<String, VectorSpace> actionSpace) {
    this.actionSpace = actionSpace;
    return this;
  }

  public Benchmark putActionSpaceItem(String key, VectorSpace actionSpaceItem) {
    if (this.actionSpace == null) {
      this.actionSpace = new HashMap<>();
    }
    this.actionSpace.put(key, actionSpaceItem);
    return this;
  }

  /**
   * Name of an action value → what it means.
   * @return actionSpace
   */
  @javax.annotation.Nonnull
  public Map<String, VectorSpace> getActionSpace() {
    return actionSpace;
  }

  public void setActionSpace(@javax.annotation.Nonnull Map<String, VectorSpace> actionSpace) {
    this.actionSpace = actionSpace;
  }


  public Benchmark observationSpace(@javax.annotation.Nonnull ObservationSpace observationSpace) {
    this.observationSpace = observationSpace;
    return this;
  }

  /**
   * Get observationSpace
   * @return observationSpace
   */
  @javax.annotation.Nonnull
  public ObservationSpace getObservationSpace() {
    return observationSpace;
  }

  public void setObservationSpace(@javax.annotation.Nonnull ObservationSpace observationSpace) {
    this.observationSpace = observationSpace;
  }


  public Benchmark imageSizes(@javax.annotation.Nonnull List<ImageSize> imageSizes) {
    this.imageSizes = imageSizes;
    return this;
  }

  public Benchmark addImageSizesItem(ImageSize imageSizesItem) {
    if (this.imageSizes == null) {
      this.imageSizes = new ArrayList<>();
    }
    this.imageSizes.add(imageSizesItem);
    return this;
  }

  /**
   * Sizes that may be chosen at submit; the first is the default.
   * @return imageSizes
   */
  @javax.annotation.Nonnull
  public List<ImageSize> getImageSizes() {
    return imageSizes;
  }

  public void setImageSizes(@javax.annotation.Nonnull List<ImageSize> imageSizes) {
    this.imageSizes = imageSizes;
  }


  public Benchmark imageCodecs(@javax.annotation.Nonnull List<String> imageCodecs) {
    this.imageCodecs = imageCodecs;
    return this;
  }

  public Benchmark addImageCodecsItem(String imageCodecsItem) {
    if (this.imageCodecs == null) {
      this.imageCodecs = new ArrayList<>();
    }
    this.imageCodecs.add(imageCodecsItem);
    return this;
  }

  /**
   * Codecs that may be chosen at submit; the first is the default.
   * @return imageCodecs
   */
  @javax.annotation.Nonnull
  public List<String> getImageCodecs() {
    return imageCodecs;
  }

  public void setImageCodecs(@javax.annotation.Nonnull List<String> imageCodecs) {
    this.imageCodecs = imageCodecs;
  }


  public Benchmark simulator(@javax.annotation.Nonnull SimulatorInfo simulator) {
    this.simulator = simulator;
    return this;
  }

  /**
   * Get simulator
   * @return simulator
   */
  @javax.annotation.Nonnull
  public SimulatorInfo getSimulator() {
    return simulator;
  }

  public void setSimulator(@javax.annotation.Nonnull SimulatorInfo simulator) {
    this.simulator = simulator;
  }


  public Benchmark unavailableReason(@javax.annotation.Nullable String unavailableReason) {
    this.unavailableReason = unavailableReason;
    return this;
  }

  /**
   * Why a run cannot be submitted here now, and the cure; null when it can.
   * @return unavailableReason
   */
  @javax.annotation.Nullable
  public String getUnavailableReason() {
    return unavailableReason;
  }

  public void setUnavailableReason(@javax.annotation.Nullable String unavailableReason) {
    this.unavailableReason = unavailableReason;
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
   * @return the Benchmark instance itself
   */
  public Benchmark putAdditionalProperty(String key, Object value) {
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
    Benchmark benchmark = (Benchmark) o;
    return Objects.equals(this.benchmarkId, benchmark.benchmarkId) &&
        Objects.equals(this.version, benchmark.version) &&
        Objects.equals(this.title, benchmark.title) &&
        Objects.equals(this.description, benchmark.description) &&
        Objects.equals(this.manifestSha256, benchmark.manifestSha256) &&
        Objects.equals(this.episodesTotal, benchmark.episodesTotal) &&
        Objects.equals(this.tasks, benchmark.tasks) &&
        Objects.equals(this.splits, benchmark.splits) &&
        Objects.equals(this.controlRateHz, benchmark.controlRateHz) &&
        Objects.equals(this.maxSteps, benchmark.maxSteps) &&
        Objects.equals(this.maxChunk, benchmark.maxChunk) &&
        Objects.equals(this.maxAttempts, benchmark.maxAttempts) &&
        Objects.equals(this.maxFaults, benchmark.maxFaults) &&
        Objects.equals(this.successRule, benchmark.successRule) &&
        Objects.equals(this.actionSpace, benchmark.actionSpace) &&
        Objects.equals(this.observationSpace, benchmark.observationSpace) &&
        Objects.equals(this.imageSizes, benchmark.imageSizes) &&
        Objects.equals(this.imageCodecs, benchmark.imageCodecs) &&
        Objects.equals(this.simulator, benchmark.simulator) &&
        Objects.equals(this.unavailableReason, benchmark.unavailableReason)&&
        Objects.equals(this.additionalProperties, benchmark.additionalProperties);
  }

  @Override
  public int hashCode() {
    return Objects.hash(benchmarkId, version, title, description, manifestSha256, episodesTotal, tasks, splits, controlRateHz, maxSteps, maxChunk, maxAttempts, maxFaults, successRule, actionSpace, observationSpace, imageSizes, imageCodecs, simulator, unavailableReason, additionalProperties);
  }

  @Override
  public String toString() {
    StringBuilder sb = new StringBuilder();
    sb.append("class Benchmark {\n");
    sb.append("    benchmarkId: ").append(toIndentedString(benchmarkId)).append("\n");
    sb.append("    version: ").append(toIndentedString(version)).append("\n");
    sb.append("    title: ").append(toIndentedString(title)).append("\n");
    sb.append("    description: ").append(toIndentedString(description)).append("\n");
    sb.append("    manifestSha256: ").append(toIndentedString(manifestSha256)).append("\n");
    sb.append("    episodesTotal: ").append(toIndentedString(episodesTotal)).append("\n");
    sb.append("    tasks: ").append(toIndentedString(tasks)).append("\n");
    sb.append("    splits: ").append(toIndentedString(splits)).append("\n");
    sb.append("    controlRateHz: ").append(toIndentedString(controlRateHz)).append("\n");
    sb.append("    maxSteps: ").append(toIndentedString(maxSteps)).append("\n");
    sb.append("    maxChunk: ").append(toIndentedString(maxChunk)).append("\n");
    sb.append("    maxAttempts: ").append(toIndentedString(maxAttempts)).append("\n");
    sb.append("    maxFaults: ").append(toIndentedString(maxFaults)).append("\n");
    sb.append("    successRule: ").append(toIndentedString(successRule)).append("\n");
    sb.append("    actionSpace: ").append(toIndentedString(actionSpace)).append("\n");
    sb.append("    observationSpace: ").append(toIndentedString(observationSpace)).append("\n");
    sb.append("    imageSizes: ").append(toIndentedString(imageSizes)).append("\n");
    sb.append("    imageCodecs: ").append(toIndentedString(imageCodecs)).append("\n");
    sb.append("    simulator: ").append(toIndentedString(simulator)).append("\n");
    sb.append("    unavailableReason: ").append(toIndentedString(unavailableReason)).append("\n");
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
    openapiFields = new HashSet<String>(Arrays.asList("benchmark_id", "version", "title", "description", "manifest_sha256", "episodes_total", "tasks", "splits", "control_rate_hz", "max_steps", "max_chunk", "max_attempts", "max_faults", "success_rule", "action_space", "observation_space", "image_sizes", "image_codecs", "simulator", "unavailable_reason"));

    // a set of required properties/fields (JSON key names)
    openapiRequiredFields = new HashSet<String>(Arrays.asList("benchmark_id", "version", "title", "description", "manifest_sha256", "episodes_total", "tasks", "splits", "control_rate_hz", "max_steps", "max_chunk", "max_attempts", "max_faults", "success_rule", "action_space", "observation_space", "image_sizes", "image_codecs", "simulator", "unavailable_reason"));
  }

  /**
   * Validates the JSON Element and throws an exception if issues found
   *
   * @param jsonElement JSON Element
   * @throws IOException if the JSON Element is invalid with respect to Benchmark
   */
  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
      if (jsonElement == null) {
        if (!Benchmark.openapiRequiredFields.isEmpty()) { // has required fields but JSON element is null
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field(s) %s in Benchmark is not found in the empty JSON string", Benchmark.openapiRequiredFields.toString()));
        }
      }

      // check to make sure all required properties/fields are present in the JSON string
      for (String requiredField : Benchmark.openapiRequiredFields) {
        if (jsonElement.getAsJsonObject().get(requiredField) == null) {
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field `%s` is not found in the JSON string: %s", requiredField, jsonElement.toString()));
        }
      }
        JsonObject jsonObj = jsonElement.getAsJsonObject();
      if (!jsonObj.get("benchmark_id").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `benchmark_id` to be a primitive type in the JSON string but got `%s`", jsonObj.get("benchmark_id").toString()));
      }
      if (!jsonObj.get("version").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `version` to be a primitive type in the JSON string but got `%s`", jsonObj.get("version").toString()));
      }
      if (!jsonObj.get("title").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `title` to be a primitive type in the JSON string but got `%s`", jsonObj.get("title").toString()));
      }
      if (!jsonObj.get("description").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `description` to be a primitive type in the JSON string but got `%s`", jsonObj.get("description").toString()));
      }
      if (!jsonObj.get("manifest_sha256").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `manifest_sha256` to be a primitive type in the JSON string but got `%s`", jsonObj.get("manifest_sha256").toString()));
      }
      // ensure the required json array is present
      if (jsonObj.get("tasks") == null) {
        throw new IllegalArgumentException("Expected the field `linkedContent` to be an array in the JSON string but got `null`");
      } else if (!jsonObj.get("tasks").isJsonArray()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `tasks` to be an array in the JSON string but got `%s`", jsonObj.get("tasks").toString()));
      }
      // ensure the required json array is present
      if (jsonObj.get("splits") == null) {
        throw new IllegalArgumentException("Expected the field `linkedContent` to be an array in the JSON string but got `null`");
      } else if (!jsonObj.get("splits").isJsonArray()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `splits` to be an array in the JSON string but got `%s`", jsonObj.get("splits").toString()));
      }
      if (!jsonObj.get("success_rule").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `success_rule` to be a primitive type in the JSON string but got `%s`", jsonObj.get("success_rule").toString()));
      }
      // ensure the required json array is present
      if (jsonObj.get("image_sizes") == null) {
        throw new IllegalArgumentException("Expected the field `linkedContent` to be an array in the JSON string but got `null`");
      } else if (!jsonObj.get("image_sizes").isJsonArray()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `image_sizes` to be an array in the JSON string but got `%s`", jsonObj.get("image_sizes").toString()));
      }
      // ensure the required json array is present
      if (jsonObj.get("image_codecs") == null) {
        throw new IllegalArgumentException("Expected the field `linkedContent` to be an array in the JSON string but got `null`");
      } else if (!jsonObj.get("image_codecs").isJsonArray()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `image_codecs` to be an array in the JSON string but got `%s`", jsonObj.get("image_codecs").toString()));
      }
      if ((jsonObj.get("unavailable_reason") != null && !jsonObj.get("unavailable_reason").isJsonNull()) && !jsonObj.get("unavailable_reason").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `unavailable_reason` to be a primitive type in the JSON string but got `%s`", jsonObj.get("unavailable_reason").toString()));
      }
  }

  public static class CustomTypeAdapterFactory implements TypeAdapterFactory {
    @SuppressWarnings("unchecked")
    @Override
    public <T> TypeAdapter<T> create(Gson gson, TypeToken<T> type) {
       if (!Benchmark.class.isAssignableFrom(type.getRawType())) {
         return null; // this class only serializes 'Benchmark' and its subtypes
       }
       final TypeAdapter<JsonElement> elementAdapter = gson.getAdapter(JsonElement.class);
       final TypeAdapter<Benchmark> thisAdapter
                        = gson.getDelegateAdapter(this, TypeToken.get(Benchmark.class));

       return (TypeAdapter<T>) new TypeAdapter<Benchmark>() {
           @Override
           public void write(JsonWriter out, Benchmark value) throws IOException {
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
           public Benchmark read(JsonReader in) throws IOException {
             JsonElement jsonElement = elementAdapter.read(in);
             validateJsonElement(jsonElement);
             JsonObject jsonObj = jsonElement.getAsJsonObject();
             // store additional fields in the deserialized instance
             Benchmark instance = thisAdapter.fromJsonTree(jsonObj);
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
   * Create an instance of Benchmark given an JSON string
   *
   * @param jsonString JSON string
   * @return An instance of Benchmark
   * @throws IOException if the JSON string is invalid with respect to Benchmark
   */
  public static Benchmark fromJson(String jsonString) throws IOException {
    return JSON.getGson().fromJson(jsonString, Benchmark.class);
  }

  /**
   * Convert an instance of Benchmark to an JSON string
   *
   * @return JSON string
   */
  public String toJson() {
    return JSON.getGson().toJson(this);
  }
}
