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
 * Gets or Sets OutOfRange
 */
@JsonAdapter(OutOfRange.Adapter.class)
public enum OutOfRange {

  REFUSE("refuse"),

  CLIP("clip"),

  UNBOUNDED("unbounded"),

  UNKNOWN_DEFAULT_OPEN_API("unknown_default_open_api");

  private String value;

  OutOfRange(String value) {
    this.value = value;
  }

  public String getValue() {
    return value;
  }

  @Override
  public String toString() {
    return String.valueOf(value);
  }

  public static OutOfRange fromValue(String value) {
    for (OutOfRange b : OutOfRange.values()) {
      if (b.value.equals(value)) {
        return b;
      }
    }
    return UNKNOWN_DEFAULT_OPEN_API;
  }

  public static class Adapter extends TypeAdapter<OutOfRange> {
    @Override
    public void write(final JsonWriter jsonWriter, final OutOfRange enumeration) throws IOException {
      jsonWriter.value(enumeration.getValue());
    }

    @Override
    public OutOfRange read(final JsonReader jsonReader) throws IOException {
      String value = jsonReader.nextString();
      return OutOfRange.fromValue(value);
    }
  }

  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
    String value = jsonElement.getAsString();
    OutOfRange.fromValue(value);
  }
}
