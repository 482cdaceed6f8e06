/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


package proctor.client.model;

import java.util.Objects;
import com.google.gson.annotations.SerializedName;

import java.io.IOException;
import com.google.gson.TypeAdapter;
import com.google.gson.JsonElement;
import com.google.gson.annotations.JsonAdapter;
import com.google.gson.stream.JsonReader;
import com.google.gson.stream.JsonWriter;

/**
 * Gets or Sets CalibrationTask
 */
@JsonAdapter(CalibrationTask.Adapter.class)
public enum CalibrationTask {

  SCORE("score"),

  COUNT("count"),

  ECHO("echo"),

  DELAY("delay"),

  FAULT("fault"),

  UNKNOWN_DEFAULT_OPEN_API("unknown_default_open_api");

  private String value;

  CalibrationTask(String value) {
    this.value = value;
  }

  public String getValue() {
    return value;
  }

  @Override
  public String toString() {
    return String.valueOf(value);
  }

  public static CalibrationTask fromValue(String value) {
    for (CalibrationTask b : CalibrationTask.values()) {
      if (b.value.equals(value)) {
        return b;
      }
    }
    return UNKNOWN_DEFAULT_OPEN_API;
  }

  public static class Adapter extends TypeAdapter<CalibrationTask> {
    @Override
    public void write(final JsonWriter jsonWriter, final CalibrationTask enumeration) throws IOException {
      jsonWriter.value(enumeration.getValue());
    }

    @Override
    public CalibrationTask read(final JsonReader jsonReader) throws IOException {
      String value = jsonReader.nextString();
      return CalibrationTask.fromValue(value);
    }
  }

  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
    String value = jsonElement.getAsString();
    CalibrationTask.fromValue(value);
  }
}
