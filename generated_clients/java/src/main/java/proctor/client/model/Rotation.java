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
 * Gets or Sets Rotation
 */
@JsonAdapter(Rotation.Adapter.class)
public enum Rotation {

  NONE("none"),

  QUATERNION_WXYZ("quaternion_wxyz"),

  QUATERNION_XYZW("quaternion_xyzw"),

  AXIS_ANGLE("axis_angle"),

  EULER_XYZ("euler_xyz"),

  ROT6D_COLUMNS("rot6d_columns"),

  UNKNOWN_DEFAULT_OPEN_API("unknown_default_open_api");

  private String value;

  Rotation(String value) {
    this.value = value;
  }

  public String getValue() {
    return value;
  }

  @Override
  public String toString() {
    return String.valueOf(value);
  }

  public static Rotation fromValue(String value) {
    for (Rotation b : Rotation.values()) {
      if (b.value.equals(value)) {
        return b;
      }
    }
    return UNKNOWN_DEFAULT_OPEN_API;
  }

  public static class Adapter extends TypeAdapter<Rotation> {
    @Override
    public void write(final JsonWriter jsonWriter, final Rotation enumeration) throws IOException {
      jsonWriter.value(enumeration.getValue());
    }

    @Override
    public Rotation read(final JsonReader jsonReader) throws IOException {
      String value = jsonReader.nextString();
      return Rotation.fromValue(value);
    }
  }

  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
    String value = jsonElement.getAsString();
    Rotation.fromValue(value);
  }
}
