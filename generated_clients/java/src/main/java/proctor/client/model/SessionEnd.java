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
 * What ended the session, as far as the server still knows; &#x60;unknown&#x60; after a restart, and for a session that was taken over and whose successor has ended.
 */
@JsonAdapter(SessionEnd.Adapter.class)
public enum SessionEnd {

  LEASE_ENDED("lease_ended"),

  DETACHED("detached"),

  RUN_STOPPED("run_stopped"),

  RUN_FAILED("run_failed"),

  UNKNOWN("unknown"),

  UNKNOWN_DEFAULT_OPEN_API("unknown_default_open_api");

  private String value;

  SessionEnd(String value) {
    this.value = value;
  }

  public String getValue() {
    return value;
  }

  @Override
  public String toString() {
    return String.valueOf(value);
  }

  public static SessionEnd fromValue(String value) {
    for (SessionEnd b : SessionEnd.values()) {
      if (b.value.equals(value)) {
        return b;
      }
    }
    return UNKNOWN_DEFAULT_OPEN_API;
  }

  public static class Adapter extends TypeAdapter<SessionEnd> {
    @Override
    public void write(final JsonWriter jsonWriter, final SessionEnd enumeration) throws IOException {
      jsonWriter.value(enumeration.getValue());
    }

    @Override
    public SessionEnd read(final JsonReader jsonReader) throws IOException {
      String value = jsonReader.nextString();
      return SessionEnd.fromValue(value);
    }
  }

  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
    String value = jsonElement.getAsString();
    SessionEnd.fromValue(value);
  }
}
