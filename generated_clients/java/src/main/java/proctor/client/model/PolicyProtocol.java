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
 * &#x60;proctor&#x60; is policy.yaml. &#x60;openai_chat&#x60; asks for a chat completion at &#x60;chat/completions&#x60; below the URL, for benchmarks that are answered in words.
 */
@JsonAdapter(PolicyProtocol.Adapter.class)
public enum PolicyProtocol {

  PROCTOR("proctor"),

  OPENAI_CHAT("openai_chat"),

  UNKNOWN_DEFAULT_OPEN_API("unknown_default_open_api");

  private String value;

  PolicyProtocol(String value) {
    this.value = value;
  }

  public String getValue() {
    return value;
  }

  @Override
  public String toString() {
    return String.valueOf(value);
  }

  public static PolicyProtocol fromValue(String value) {
    for (PolicyProtocol b : PolicyProtocol.values()) {
      if (b.value.equals(value)) {
        return b;
      }
    }
    return UNKNOWN_DEFAULT_OPEN_API;
  }

  public static class Adapter extends TypeAdapter<PolicyProtocol> {
    @Override
    public void write(final JsonWriter jsonWriter, final PolicyProtocol enumeration) throws IOException {
      jsonWriter.value(enumeration.getValue());
    }

    @Override
    public PolicyProtocol read(final JsonReader jsonReader) throws IOException {
      String value = jsonReader.nextString();
      return PolicyProtocol.fromValue(value);
    }
  }

  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
    String value = jsonElement.getAsString();
    PolicyProtocol.fromValue(value);
  }
}
