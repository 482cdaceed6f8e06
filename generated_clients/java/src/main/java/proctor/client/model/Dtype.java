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
 * Gets or Sets Dtype
 */
@JsonAdapter(Dtype.Adapter.class)
public enum Dtype {

  BOOL("bool"),

  INT8("int8"),

  INT16("int16"),

  INT32("int32"),

  INT64("int64"),

  UINT8("uint8"),

  UINT16("uint16"),

  UINT32("uint32"),

  UINT64("uint64"),

  FLOAT16("float16"),

  FLOAT32("float32"),

  FLOAT64("float64"),

  UNKNOWN_DEFAULT_OPEN_API("unknown_default_open_api");

  private String value;

  Dtype(String value) {
    this.value = value;
  }

  public String getValue() {
    return value;
  }

  @Override
  public String toString() {
    return String.valueOf(value);
  }

  public static Dtype fromValue(String value) {
    for (Dtype b : Dtype.values()) {
      if (b.value.equals(value)) {
        return b;
      }
    }
    return UNKNOWN_DEFAULT_OPEN_API;
  }

  public static class Adapter extends TypeAdapter<Dtype> {
    @Override
    public void write(final JsonWriter jsonWriter, final Dtype enumeration) throws IOException {
      jsonWriter.value(enumeration.getValue());
    }

    @Override
    public Dtype read(final JsonReader jsonReader) throws IOException {
      String value = jsonReader.nextString();
      return Dtype.fromValue(value);
    }
  }

  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
    String value = jsonElement.getAsString();
    Dtype.fromValue(value);
  }
}
