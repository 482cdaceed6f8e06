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
 * &#x60;last&#x60; when absent; &#x60;all&#x60; adds the observation after every executed action.
 */
@JsonAdapter(Observe.Adapter.class)
public enum Observe {

  LAST("last"),

  ALL("all"),

  UNKNOWN_DEFAULT_OPEN_API("unknown_default_open_api");

  private String value;

  Observe(String value) {
    this.value = value;
  }

  public String getValue() {
    return value;
  }

  @Override
  public String toString() {
    return String.valueOf(value);
  }

  public static Observe fromValue(String value) {
    for (Observe b : Observe.values()) {
      if (b.value.equals(value)) {
        return b;
      }
    }
    return UNKNOWN_DEFAULT_OPEN_API;
  }

  public static class Adapter extends TypeAdapter<Observe> {
    @Override
    public void write(final JsonWriter jsonWriter, final Observe enumeration) throws IOException {
      jsonWriter.value(enumeration.getValue());
    }

    @Override
    public Observe read(final JsonReader jsonReader) throws IOException {
      String value = jsonReader.nextString();
      return Observe.fromValue(value);
    }
  }

  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
    String value = jsonElement.getAsString();
    Observe.fromValue(value);
  }
}
