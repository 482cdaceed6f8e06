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
 * Gets or Sets Profile
 */
@JsonAdapter(Profile.Adapter.class)
public enum Profile {

  CORE("core"),

  MSGPACK("msgpack"),

  COMPARE("compare"),

  EVENTS("events"),

  PUSH("push"),

  EBENCH("ebench"),

  FLAGEVAL("flageval"),

  UNKNOWN_DEFAULT_OPEN_API("unknown_default_open_api");

  private String value;

  Profile(String value) {
    this.value = value;
  }

  public String getValue() {
    return value;
  }

  @Override
  public String toString() {
    return String.valueOf(value);
  }

  public static Profile fromValue(String value) {
    for (Profile b : Profile.values()) {
      if (b.value.equals(value)) {
        return b;
      }
    }
    return UNKNOWN_DEFAULT_OPEN_API;
  }

  public static class Adapter extends TypeAdapter<Profile> {
    @Override
    public void write(final JsonWriter jsonWriter, final Profile enumeration) throws IOException {
      jsonWriter.value(enumeration.getValue());
    }

    @Override
    public Profile read(final JsonReader jsonReader) throws IOException {
      String value = jsonReader.nextString();
      return Profile.fromValue(value);
    }
  }

  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
    String value = jsonElement.getAsString();
    Profile.fromValue(value);
  }
}
