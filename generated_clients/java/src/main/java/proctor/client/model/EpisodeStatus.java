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
 * Gets or Sets EpisodeStatus
 */
@JsonAdapter(EpisodeStatus.Adapter.class)
public enum EpisodeStatus {

  PENDING("pending"),

  IN_PROGRESS("in_progress"),

  SCORED("scored"),

  UNKNOWN_DEFAULT_OPEN_API("unknown_default_open_api");

  private String value;

  EpisodeStatus(String value) {
    this.value = value;
  }

  public String getValue() {
    return value;
  }

  @Override
  public String toString() {
    return String.valueOf(value);
  }

  public static EpisodeStatus fromValue(String value) {
    for (EpisodeStatus b : EpisodeStatus.values()) {
      if (b.value.equals(value)) {
        return b;
      }
    }
    return UNKNOWN_DEFAULT_OPEN_API;
  }

  public static class Adapter extends TypeAdapter<EpisodeStatus> {
    @Override
    public void write(final JsonWriter jsonWriter, final EpisodeStatus enumeration) throws IOException {
      jsonWriter.value(enumeration.getValue());
    }

    @Override
    public EpisodeStatus read(final JsonReader jsonReader) throws IOException {
      String value = jsonReader.nextString();
      return EpisodeStatus.fromValue(value);
    }
  }

  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
    String value = jsonElement.getAsString();
    EpisodeStatus.fromValue(value);
  }
}
