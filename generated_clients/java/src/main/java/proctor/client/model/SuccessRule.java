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
 * Gets or Sets SuccessRule
 */
@JsonAdapter(SuccessRule.Adapter.class)
public enum SuccessRule {

  ANY_STEP("any_step"),

  LAST_STEP("last_step"),

  UNKNOWN_DEFAULT_OPEN_API("unknown_default_open_api");

  private String value;

  SuccessRule(String value) {
    this.value = value;
  }

  public String getValue() {
    return value;
  }

  @Override
  public String toString() {
    return String.valueOf(value);
  }

  public static SuccessRule fromValue(String value) {
    for (SuccessRule b : SuccessRule.values()) {
      if (b.value.equals(value)) {
        return b;
      }
    }
    return UNKNOWN_DEFAULT_OPEN_API;
  }

  public static class Adapter extends TypeAdapter<SuccessRule> {
    @Override
    public void write(final JsonWriter jsonWriter, final SuccessRule enumeration) throws IOException {
      jsonWriter.value(enumeration.getValue());
    }

    @Override
    public SuccessRule read(final JsonReader jsonReader) throws IOException {
      String value = jsonReader.nextString();
      return SuccessRule.fromValue(value);
    }
  }

  public static void validateJsonElement(JsonElement jsonElement) throws IOException {
    String value = jsonElement.getAsString();
    SuccessRule.fromValue(value);
  }
}
