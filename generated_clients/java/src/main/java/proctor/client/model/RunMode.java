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
 * &#x60;pull&#x60; when absent: workers attach and predict. &#x60;push&#x60;: the server calls the policy itself, and workers of the run are its own.
 */
@JsonAdapter(RunMode.Adapter.class)
public enum RunMode {

  PULL("pull"),

  PUSH("push"),

  UNKNOWN_DEFAULT_OPEN_API("unknown_default_open_api");

  private String value;

  RunMode(String value) {
    this.value = value;
  }

  public String getValue() {
    return value;
  }

  @Override
  public String toString() {
    return String.valueOf(value);
  }

  public static RunMode fromValue(String value) {
    for (RunMode b : RunMode.values()) {
      if (b.value.equals(value)) {
        return b;
      }
    }
    return UNKNOWN_DEFAULT_OPEN_API;
  }

  public static class Adapter extends TypeAdapter<RunMode> {
    @Override
    public void write(final JsonWriter jsonWriter, final RunMode enumeration) throws IOException {
      jsonWriter.value(enumeration.getValue());
    }

    @Override
    public RunMode read(final JsonReader jsonReader) throws IOException {
      String value = jsonReader.nextString();
      return RunMode.fromValue(value);
    }
  }

  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
    String value = jsonElement.getAsString();
    RunMode.fromValue(value);
  }
}
