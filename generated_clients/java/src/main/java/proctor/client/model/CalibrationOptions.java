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
import proctor.client.model.CalibrationTask;
import proctor.client.model.SuccessRule;

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
 * Only for the benchmark &#x60;calibration&#x60;, which the submitter shapes.
 */
@javax.annotation.Generated(value = "org.openapitools.codegen.languages.JavaClientCodegen", comments = "Generator version: 7.26.0")
public class CalibrationOptions {
  public static final String SERIALIZED_NAME_TASKS = "tasks";
  @SerializedName(SERIALIZED_NAME_TASKS)
  @javax.annotation.Nullable
  private List<CalibrationTask> tasks;

  public static final String SERIALIZED_NAME_MAX_STEPS = "max_steps";
  @SerializedName(SERIALIZED_NAME_MAX_STEPS)
  @javax.annotation.Nullable
  private Integer maxSteps;

  public static final String SERIALIZED_NAME_SUCCESS_RULE = "success_rule";
  @SerializedName(SERIALIZED_NAME_SUCCESS_RULE)
  @javax.annotation.Nullable
  private SuccessRule successRule;

  public static final String SERIALIZED_NAME_MAX_ATTEMPTS = "max_attempts";
  @SerializedName(SERIALIZED_NAME_MAX_ATTEMPTS)
  @javax.annotation.Nullable
  private Integer maxAttempts;

  public static final String SERIALIZED_NAME_MAX_FAULTS = "max_faults";
  @SerializedName(SERIALIZED_NAME_MAX_FAULTS)
  @javax.annotation.Nullable
  private Integer maxFaults;

  public static final String SERIALIZED_NAME_QUEUE_S = "queue_s";
  @SerializedName(SERIALIZED_NAME_QUEUE_S)
  @javax.annotation.Nullable
  private Double queueS;

  public CalibrationOptions() {
  }

  public CalibrationOptions tasks(@javax.annotation.Nullable List<CalibrationTask> tasks) {
    this.tasks = tasks;
    return this;
  }

  public CalibrationOptions addTasksItem(CalibrationTask tasksItem) {
    if (this.tasks == null) {
      this.tasks = new ArrayList<>();
    }
    this.tasks.add(tasksItem);
    return this;
  }

  /**
   * One entry per episode, in order; one &#x60;score&#x60; episode when absent.
   * @return tasks
   */
  @javax.annotation.Nullable
  public List<CalibrationTask> getTasks() {
    return tasks;
  }

  public void setTasks(@javax.annotation.Nullable List<CalibrationTask> tasks) {
    this.tasks = tasks;
  }


  public CalibrationOptions maxSteps(@javax.annotation.Nullable Integer maxSteps) {
    this.maxSteps = maxSteps;
    return this;
  }

  /**
   * 10 when absent.
   * minimum: 1
   * maximum: 10000
   * @return maxSteps
   */
  @javax.annotation.Nullable
  public Integer getMaxSteps() {
    return maxSteps;
  }

  public void setMaxSteps(@javax.annotation.Nullable Integer maxSteps) {
    this.maxSteps = maxSteps;
  }


  public CalibrationOptions successRule(@javax.annotation.Nullable SuccessRule successRule) {
    this.successRule = successRule;
    return this;
  }

  /**
   * Get successRule
   * @return successRule
   */
  @javax.annotation.Nullable
  public SuccessRule getSuccessRule() {
    return successRule;
  }

  public void setSuccessRule(@javax.annotation.Nullable SuccessRule successRule) {
    this.successRule = successRule;
  }


  public CalibrationOptions maxAttempts(@javax.annotation.Nullable Integer maxAttempts) {
    this.maxAttempts = maxAttempts;
    return this;
  }

  /**
   * 3 when absent.
   * minimum: 1
   * maximum: 10
   * @return maxAttempts
   */
  @javax.annotation.Nullable
  public Integer getMaxAttempts() {
    return maxAttempts;
  }

  public void setMaxAttempts(@javax.annotation.Nullable Integer maxAttempts) {
    this.maxAttempts = maxAttempts;
  }


  public CalibrationOptions maxFaults(@javax.annotation.Nullable Integer maxFaults) {
    this.maxFaults = maxFaults;
    return this;
  }

  /**
   * 3 when absent.
   * minimum: 1
   * maximum: 10
   * @return maxFaults
   */
  @javax.annotation.Nullable
  public Integer getMaxFaults() {
    return maxFaults;
  }

  public void setMaxFaults(@javax.annotation.Nullable Integer maxFaults) {
    this.maxFaults = maxFaults;
  }


  public CalibrationOptions queueS(@javax.annotation.Nullable Double queueS) {
    this.queueS = queueS;
    return this;
  }

  /**
   * Seconds for which the run stays queued after submit and after resume; 0 when absent.
   * minimum: 0
   * maximum: 10
   * @return queueS
   */
  @javax.annotation.Nullable
  public Double getQueueS() {
    return queueS;
  }

  public void setQueueS(@javax.annotation.Nullable Double queueS) {
    this.queueS = queueS;
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
   * @return the CalibrationOptions instance itself
   */
  public CalibrationOptions putAdditionalProperty(String key, Object value) {
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
    CalibrationOptions calibrationOptions = (CalibrationOptions) o;
    return Objects.equals(this.tasks, calibrationOptions.tasks) &&
        Objects.equals(this.maxSteps, calibrationOptions.maxSteps) &&
        Objects.equals(this.successRule, calibrationOptions.successRule) &&
        Objects.equals(this.maxAttempts, calibrationOptions.maxAttempts) &&
        Objects.equals(this.maxFaults, calibrationOptions.maxFaults) &&
        Objects.equals(this.queueS, calibrationOptions.queueS)&&
        Objects.equals(this.additionalProperties, calibrationOptions.additionalProperties);
  }

  @Override
  public int hashCode() {
    return Objects.hash(tasks, maxSteps, successRule, maxAttempts, maxFaults, queueS, additionalProperties);
  }

  @Override
  public String toString() {
    StringBuilder sb = new StringBuilder();
    sb.append("class CalibrationOptions {\n");
    sb.append("    tasks: ").append(toIndentedString(tasks)).append("\n");
    sb.append("    maxSteps: ").append(toIndentedString(maxSteps)).append("\n");
    sb.append("    successRule: ").append(toIndentedString(successRule)).append("\n");
    sb.append("    maxAttempts: ").append(toIndentedString(maxAttempts)).append("\n");
    sb.append("    maxFaults: ").append(toIndentedString(maxFaults)).append("\n");
    sb.append("    queueS: ").append(toIndentedString(queueS)).append("\n");
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
    openapiFields = new HashSet<String>(Arrays.asList("tasks", "max_steps", "success_rule", "max_attempts", "max_faults", "queue_s"));

    // a set of required properties/fields (JSON key names)
    openapiRequiredFields = new HashSet<String>(0);
  }

  /**
   * Validates the JSON Element and throws an exception if issues found
   *
   * @param jsonElement JSON Element
   * @throws IOException if the JSON Element is invalid with respect to CalibrationOptions
   */
  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
      if (jsonElement == null) {
        if (!CalibrationOptions.openapiRequiredFields.isEmpty()) { // has required fields but JSON element is null
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field(s) %s in CalibrationOptions is not found in the empty JSON string", CalibrationOptions.openapiRequiredFields.toString()));
        }
      }
        JsonObject jsonObj = jsonElement.getAsJsonObject();
      // ensure the optional json data is an array if present
      if (jsonObj.get("tasks") != null && !jsonObj.get("tasks").isJsonNull() && !jsonObj.get("tasks").isJsonArray()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `tasks` to be an array in the JSON string but got `%s`", jsonObj.get("tasks").toString()));
      }
      // validate the optional field `success_rule`
      if (jsonObj.get("success_rule") != null && !jsonObj.get("success_rule").isJsonNull()) {
        SuccessRule.validateJsonElement(jsonObj.get("success_rule"));
      }
  }

  public static class CustomTypeAdapterFactory implements TypeAdapterFactory {
    @SuppressWarnings("unchecked")
    @Override
    public <T> TypeAdapter<T> create(Gson gson, TypeToken<T> type) {
       if (!CalibrationOptions.class.isAssignableFrom(type.getRawType())) {
         return null; // this class only serializes 'CalibrationOptions' and its subtypes
       }
       final TypeAdapter<JsonElement> elementAdapter = gson.getAdapter(JsonElement.class);
       final TypeAdapter<CalibrationOptions> thisAdapter
                        = gson.getDelegateAdapter(this, TypeToken.get(CalibrationOptions.class));

       return (TypeAdapter<T>) new TypeAdapter<CalibrationOptions>() {
           @Override
           public void write(JsonWriter out, CalibrationOptions value) throws IOException {
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
           public CalibrationOptions read(JsonReader in) throws IOException {
             JsonElement jsonElement = elementAdapter.read(in);
             validateJsonElement(jsonElement);
             JsonObject jsonObj = jsonElement.getAsJsonObject();
             // store additional fields in the deserialized instance
             CalibrationOptions instance = thisAdapter.fromJsonTree(jsonObj);
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
   * Create an instance of CalibrationOptions given an JSON string
   *
   * @param jsonString JSON string
   * @return An instance of CalibrationOptions
   * @throws IOException if the JSON string is invalid with respect to CalibrationOptions
   */
  public static CalibrationOptions fromJson(String jsonString) throws IOException {
    return JSON.getGson().fromJson(jsonString, CalibrationOptions.class);
  }

  /**
   * Convert an instance of CalibrationOptions to an JSON string
   *
   * @return JSON string
   */
  public String toJson() {
    return JSON.getGson().toJson(this);
  }
}
