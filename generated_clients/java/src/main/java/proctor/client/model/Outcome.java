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
 * Gets or Sets Outcome
 */
@JsonAdapter(Outcome.Adapter.class)
public enum Outcome {

  SUCCESS("success"),

  FAILURE("failure"),

  ABANDONED("abandoned"),

  UNKNOWN_DEFAULT_OPEN_API("unknown_default_open_api");

  private String value;

  Outcome(String value) {
    this.value = value;
  }

  public String getValue() {
    return value;
  }

  @Override
  public String toString() {
    return String.valueOf(value);
  }

  public static Outcome fromValue(String value) {
    for (Outcome b : Outcome.values()) {
      if (b.value.equals(value)) {
        return b;
      }
    }
    return UNKNOWN_DEFAULT_OPEN_API;
  }

  public static class Adapter extends TypeAdapter<Outcome> {
    @Override
    public void write(final JsonWriter jsonWriter, final Outcome enumeration) throws IOException {
      jsonWriter.value(enumeration.getValue());
    }

    @Override
    public Outcome read(final JsonReader jsonReader) throws IOException {
      String value = jsonReader.nextString();
      return Outcome.fromValue(value);
    }
  }

  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
    String value = jsonElement.getAsString();
    Outcome.fromValue(value);
  }
}
