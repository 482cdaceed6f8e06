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
 * Gets or Sets RunState
 */
@JsonAdapter(RunState.Adapter.class)
public enum RunState {

  QUEUED("queued"),

  READY("ready"),

  RUNNING("running"),

  STOPPING("stopping"),

  STOPPED("stopped"),

  FAILED("failed"),

  COMPLETED("completed"),

  UNKNOWN_DEFAULT_OPEN_API("unknown_default_open_api");

  private String value;

  RunState(String value) {
    this.value = value;
  }

  public String getValue() {
    return value;
  }

  @Override
  public String toString() {
    return String.valueOf(value);
  }

  public static RunState fromValue(String value) {
    for (RunState b : RunState.values()) {
      if (b.value.equals(value)) {
        return b;
      }
    }
    return UNKNOWN_DEFAULT_OPEN_API;
  }

  public static class Adapter extends TypeAdapter<RunState> {
    @Override
    public void write(final JsonWriter jsonWriter, final RunState enumeration) throws IOException {
      jsonWriter.value(enumeration.getValue());
    }

    @Override
    public RunState read(final JsonReader jsonReader) throws IOException {
      String value = jsonReader.nextString();
      return RunState.fromValue(value);
    }
  }

  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
    String value = jsonElement.getAsString();
    RunState.fromValue(value);
  }
}
