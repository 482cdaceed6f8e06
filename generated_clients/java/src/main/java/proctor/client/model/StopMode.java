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
 * &#x60;abort&#x60; when absent.
 */
@JsonAdapter(StopMode.Adapter.class)
public enum StopMode {

  ABORT("abort"),

  DRAIN("drain"),

  UNKNOWN_DEFAULT_OPEN_API("unknown_default_open_api");

  private String value;

  StopMode(String value) {
    this.value = value;
  }

  public String getValue() {
    return value;
  }

  @Override
  public String toString() {
    return String.valueOf(value);
  }

  public static StopMode fromValue(String value) {
    for (StopMode b : StopMode.values()) {
      if (b.value.equals(value)) {
        return b;
      }
    }
    return UNKNOWN_DEFAULT_OPEN_API;
  }

  public static class Adapter extends TypeAdapter<StopMode> {
    @Override
    public void write(final JsonWriter jsonWriter, final StopMode enumeration) throws IOException {
      jsonWriter.value(enumeration.getValue());
    }

    @Override
    public StopMode read(final JsonReader jsonReader) throws IOException {
      String value = jsonReader.nextString();
      return StopMode.fromValue(value);
    }
  }

  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
    String value = jsonElement.getAsString();
    StopMode.fromValue(value);
  }
}
