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
 * One named vector of numbers, with every convention a policy could get wrong.
 */
@javax.annotation.Generated(value = "org.openapitools.codegen.languages.JavaClientCodegen", comments = "Generator version: 7.26.0")
public class VectorSpace {
  public static final String SERIALIZED_NAME_SIZE = "size";
  @SerializedName(SERIALIZED_NAME_SIZE)
  @javax.annotation.Nonnull
  private Integer size;

  public static final String SERIALIZED_NAME_UNIT = "unit";
  @SerializedName(SERIALIZED_NAME_UNIT)
  @javax.annotation.Nonnull
  private String unit;

  public static final String SERIALIZED_NAME_ROTATION = "rotation";
  @SerializedName(SERIALIZED_NAME_ROTATION)
  @javax.annotation.Nonnull
  private String rotation;

  public static final String SERIALIZED_NAME_FRAME = "frame";
  @SerializedName(SERIALIZED_NAME_FRAME)
  @javax.annotation.Nonnull
  private String frame;

  public static final String SERIALIZED_NAME_RELATIVE = "relative";
  @SerializedName(SERIALIZED_NAME_RELATIVE)
  @javax.annotation.Nonnull
  private Boolean relative;

  public static final String SERIALIZED_NAME_GRIPPER_OPEN = "gripper_open";
  @SerializedName(SERIALIZED_NAME_GRIPPER_OPEN)
  @javax.annotation.Nullable
  private Double gripperOpen;

  public static final String SERIALIZED_NAME_MINIMUM = "minimum";
  @SerializedName(SERIALIZED_NAME_MINIMUM)
  @javax.annotation.Nullable
  private List<Double> minimum;

  public static final String SERIALIZED_NAME_MAXIMUM = "maximum";
  @SerializedName(SERIALIZED_NAME_MAXIMUM)
  @javax.annotation.Nullable
  private List<Double> maximum;

  public static final String SERIALIZED_NAME_OUT_OF_RANGE = "out_of_range";
  @SerializedName(SERIALIZED_NAME_OUT_OF_RANGE)
  @javax.annotation.Nonnull
  private String outOfRange;

  public static final String SERIALIZED_NAME_DESCRIPTION = "description";
  @SerializedName(SERIALIZED_NAME_DESCRIPTION)
  @javax.annotation.Nullable
  private String description;

  public static final String SERIALIZED_NAME_TASKS = "tasks";
  @SerializedName(SERIALIZED_NAME_TASKS)
  @javax.annotation.Nullable
  private List<String> tasks;

  public VectorSpace() {
  }

  public VectorSpace size(@javax.annotation.Nonnull Integer size) {
    this.size = size;
    return this;
  }

  /**
   * Get size
   * minimum: 1
   * @return size
   */
  @javax.annotation.Nonnull
  public Integer getSize() {
    return size;
  }

  public void setSize(@javax.annotation.Nonnull Integer size) {
    this.size = size;
  }


  public VectorSpace unit(@javax.annotation.Nonnull String unit) {
    this.unit = unit;
    return this;
  }

  /**
   * &#x60;rad&#x60;, &#x60;m&#x60;, &#x60;1&#x60;, or several joined by commas.
   * @return unit
   */
  @javax.annotation.Nonnull
  public String getUnit() {
    return unit;
  }

  public void setUnit(@javax.annotation.Nonnull String unit) {
    this.unit = unit;
  }


  public VectorSpace rotation(@javax.annotation.Nonnull String rotation) {
    this.rotation = rotation;
    return this;
  }

  /**
   * Get rotation
   * @return rotation
   */
  @javax.annotation.Nonnull
  public String getRotation() {
    return rotation;
  }

  public void setRotation(@javax.annotation.Nonnull String rotation) {
    this.rotation = rotation;
  }


  public VectorSpace frame(@javax.annotation.Nonnull String frame) {
    this.frame = frame;
    return this;
  }

  /**
   * &#x60;world&#x60;, &#x60;base&#x60;, &#x60;tool&#x60;, &#x60;joint&#x60;, or &#x60;none&#x60;.
   * @return frame
   */
  @javax.annotation.Nonnull
  public String getFrame() {
    return frame;
  }

  public void setFrame(@javax.annotation.Nonnull String frame) {
    this.frame = frame;
  }


  public VectorSpace relative(@javax.annotation.Nonnull Boolean relative) {
    this.relative = relative;
    return this;
  }

  /**
   * True when the values are increments.
   * @return relative
   */
  @javax.annotation.Nonnull
  public Boolean getRelative() {
    return relative;
  }

  public void setRelative(@javax.annotation.Nonnull Boolean relative) {
    this.relative = relative;
  }


  public VectorSpace gripperOpen(@javax.annotation.Nullable Double gripperOpen) {
    this.gripperOpen = gripperOpen;
    return this;
  }

  /**
   * The value that means fully open.
   * @return gripperOpen
   */
  @javax.annotation.Nullable
  public Double getGripperOpen() {
    return gripperOpen;
  }

  public void setGripperOpen(@javax.annotation.Nullable Double gripperOpen) {
    this.gripperOpen = gripperOpen;
  }


  public VectorSpace minimum(@javax.annotation.Nullable List<Double> minimum) {
    this.minimum = minimum;
    return this;
  }

  public VectorSpace addMinimumItem(Double minimumItem) {
    if (this.minimum == null) {
      this.minimum = new ArrayList<>();
    }
    this.minimum.add(minimumItem);
    return this;
  }

  /**
   * Get minimum
   * @return minimum
   */
  @javax.annotation.Nullable
  public List<Double> getMinimum() {
    return minimum;
  }

  public void setMinimum(@javax.annotation.Nullable List<Double> minimum) {
    this.minimum = minimum;
  }


  public VectorSpace maximum(@javax.annotation.Nullable List<Double> maximum) {
    this.maximum = maximum;
    return this;
  }

  public VectorSpace addMaximumItem(Double maximumItem) {
    if (this.maximum == null) {
      this.maximum = new ArrayList<>();
    }
    this.maximum.add(maximumItem);
    return this;
  }

  /**
   * Get maximum
   * @return maximum
   */
  @javax.annotation.Nullable
  public List<Double> getMaximum() {
    return maximum;
  }

  public void setMaximum(@javax.annotation.Nullable List<Double> maximum) {
    this.maximum = maximum;
  }


  public VectorSpace outOfRange(@javax.annotation.Nonnull String outOfRange) {
    this.outOfRange = outOfRange;
    return this;
  }

  /**
   * Get outOfRange
   * @return outOfRange
   */
  @javax.annotation.Nonnull
  public String getOutOfRange() {
    return outOfRange;
  }

  public void setOutOfRange(@javax.annotation.Nonnull String outOfRange) {
    this.outOfRange = outOfRange;
  }


  public VectorSpace description(@javax.annotation.Nullable String description) {
    this.description = description;
    return this;
  }

  /**
   * What the numbers are.
   * @return description
   */
  @javax.annotation.Nullable
  public String getDescription() {
    return description;
  }

  public void setDescription(@javax.annotation.Nullable String description) {
    this.description = description;
  }


  public VectorSpace tasks(@javax.annotation.Nullable List<String> tasks) {
    this.tasks = tasks;
    return this;
  }

  public VectorSpace addTasksItem(String tasksItem) {
    if (this.tasks == null) {
      this.tasks = new ArrayList<>();
    }
    this.tasks.add(tasksItem);
    return this;
  }

  /**
   * The tasks that have this entry; all of them when absent.
   * @return tasks
   */
  @javax.annotation.Nullable
  public List<String> getTasks() {
    return tasks;
  }

  public void setTasks(@javax.annotation.Nullable List<String> tasks) {
    this.tasks = tasks;
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
   * @return the VectorSpace instance itself
   */
  public VectorSpace putAdditionalProperty(String key, Object value) {
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
    VectorSpace vectorSpace = (VectorSpace) o;
    return Objects.equals(this.size, vectorSpace.size) &&
        Objects.equals(this.unit, vectorSpace.unit) &&
        Objects.equals(this.rotation, vectorSpace.rotation) &&
        Objects.equals(this.frame, vectorSpace.frame) &&
        Objects.equals(this.relative, vectorSpace.relative) &&
        Objects.equals(this.gripperOpen, vectorSpace.gripperOpen) &&
        Objects.equals(this.minimum, vectorSpace.minimum) &&
        Objects.equals(this.maximum, vectorSpace.maximum) &&
        Objects.equals(this.outOfRange, vectorSpace.outOfRange) &&
        Objects.equals(this.description, vectorSpace.description) &&
        Objects.equals(this.tasks, vectorSpace.tasks)&&
        Objects.equals(this.additionalProperties, vectorSpace.additionalProperties);
  }

  @Override
  public int hashCode() {
    return Objects.hash(size, unit, rotation, frame, relative, gripperOpen, minimum, maximum, outOfRange, description, tasks, additionalProperties);
  }

  @Override
  public String toString() {
    StringBuilder sb = new StringBuilder();
    sb.append("class VectorSpace {\n");
    sb.append("    size: ").append(toIndentedString(size)).append("\n");
    sb.append("    unit: ").append(toIndentedString(unit)).append("\n");
    sb.append("    rotation: ").append(toIndentedString(rotation)).append("\n");
    sb.append("    frame: ").append(toIndentedString(frame)).append("\n");
    sb.append("    relative: ").append(toIndentedString(relative)).append("\n");
    sb.append("    gripperOpen: ").append(toIndentedString(gripperOpen)).append("\n");
    sb.append("    minimum: ").append(toIndentedString(minimum)).append("\n");
    sb.append("    maximum: ").append(toIndentedString(maximum)).append("\n");
    sb.append("    outOfRange: ").append(toIndentedString(outOfRange)).append("\n");
    sb.append("    description: ").append(toIndentedString(description)).append("\n");
    sb.append("    tasks: ").append(toIndentedString(tasks)).append("\n");
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
    openapiFields = new HashSet<String>(Arrays.asList("size", "unit", "rotation", "frame", "relative", "gripper_open", "minimum", "maximum", "out_of_range", "description", "tasks"));

    // a set of required properties/fields (JSON key names)
    openapiRequiredFields = new HashSet<String>(Arrays.asList("size", "unit", "rotation", "frame", "relative", "out_of_range"));
  }

  /**
   * Validates the JSON Element and throws an exception if issues found
   *
   * @param jsonElement JSON Element
   * @throws IOException if the JSON Element is invalid with respect to VectorSpace
   */
  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
      if (jsonElement == null) {
        if (!VectorSpace.openapiRequiredFields.isEmpty()) { // has required fields but JSON element is null
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field(s) %s in VectorSpace is not found in the empty JSON string", VectorSpace.openapiRequiredFields.toString()));
        }
      }

      // check to make sure all required properties/fields are present in the JSON string
      for (String requiredField : VectorSpace.openapiRequiredFields) {
        if (jsonElement.getAsJsonObject().get(requiredField) == null) {
          throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "The required field `%s` is not found in the JSON string: %s", requiredField, jsonElement.toString()));
        }
      }
        JsonObject jsonObj = jsonElement.getAsJsonObject();
      if (!jsonObj.get("unit").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `unit` to be a primitive type in the JSON string but got `%s`", jsonObj.get("unit").toString()));
      }
      if (!jsonObj.get("rotation").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `rotation` to be a primitive type in the JSON string but got `%s`", jsonObj.get("rotation").toString()));
      }
      if (!jsonObj.get("frame").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `frame` to be a primitive type in the JSON string but got `%s`", jsonObj.get("frame").toString()));
      }
      // ensure the optional json data is an array if present
      if (jsonObj.get("minimum") != null && !jsonObj.get("minimum").isJsonNull() && !jsonObj.get("minimum").isJsonArray()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `minimum` to be an array in the JSON string but got `%s`", jsonObj.get("minimum").toString()));
      }
      // ensure the optional json data is an array if present
      if (jsonObj.get("maximum") != null && !jsonObj.get("maximum").isJsonNull() && !jsonObj.get("maximum").isJsonArray()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `maximum` to be an array in the JSON string but got `%s`", jsonObj.get("maximum").toString()));
      }
      if (!jsonObj.get("out_of_range").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `out_of_range` to be a primitive type in the JSON string but got `%s`", jsonObj.get("out_of_range").toString()));
      }
      if ((jsonObj.get("description") != null && !jsonObj.get("description").isJsonNull()) && !jsonObj.get("description").isJsonPrimitive()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `description` to be a primitive type in the JSON string but got `%s`", jsonObj.get("description").toString()));
      }
      // ensure the optional json data is an array if present
      if (jsonObj.get("tasks") != null && !jsonObj.get("tasks").isJsonNull() && !jsonObj.get("tasks").isJsonArray()) {
        throw new IllegalArgumentException(String.format(java.util.Locale.ROOT, "Expected the field `tasks` to be an array in the JSON string but got `%s`", jsonObj.get("tasks").toString()));
      }
  }

  public static class CustomTypeAdapterFactory implements TypeAdapterFactory {
    @SuppressWarnings("unchecked")
    @Override
    public <T> TypeAdapter<T> create(Gson gson, TypeToken<T> type) {
       if (!VectorSpace.class.isAssignableFrom(type.getRawType())) {
         return null; // this class only serializes 'VectorSpace' and its subtypes
       }
       final TypeAdapter<JsonElement> elementAdapter = gson.getAdapter(JsonElement.class);
       final TypeAdapter<VectorSpace> thisAdapter
                        = gson.getDelegateAdapter(this, TypeToken.get(VectorSpace.class));

       return (TypeAdapter<T>) new TypeAdapter<VectorSpace>() {
           @Override
           public void write(JsonWriter out, VectorSpace value) throws IOException {
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
           public VectorSpace read(JsonReader in) throws IOException {
             JsonElement jsonElement = elementAdapter.read(in);
             validateJsonElement(jsonElement);
             JsonObject jsonObj = jsonElement.getAsJsonObject();
             // store additional fields in the deserialized instance
             VectorSpace instance = thisAdapter.fromJsonTree(jsonObj);
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
   * Create an instance of VectorSpace given an JSON string
   *
   * @param jsonString JSON string
   * @return An instance of VectorSpace
   * @throws IOException if the JSON string is invalid with respect to VectorSpace
   */
  public static VectorSpace fromJson(String jsonString) throws IOException {
    return JSON.getGson().fromJson(jsonString, VectorSpace.class);
  }

  /**
   * Convert an instance of VectorSpace to an JSON string
   *
   * @return JSON string
   */
  public String toJson() {
    return JSON.getGson().toJson(this);
  }
}
