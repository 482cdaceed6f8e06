/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


package proctor.client.model;

import com.google.gson.annotations.SerializedName;

/** &#x60;proctor&#x60; is policy.yaml. &#x60;openai_chat&#x60; asks for a chat completion at &#x60;chat/completions&#x60; below the URL, for benchmarks that are answered in words. &#x60;openai_completions&#x60; asks for the completion of a text at &#x60;completions&#x60; below the URL, for such benchmarks without images. */
public enum PolicyProtocol {
  @SerializedName("proctor")
  PROCTOR("proctor"),
  @SerializedName("openai_chat")
  OPENAI_CHAT("openai_chat"),
  @SerializedName("openai_completions")
  OPENAI_COMPLETIONS("openai_completions");

  private final String value;

  PolicyProtocol(String value) {
    this.value = value;
  }

  public String getValue() {
    return value;
  }

  @Override
  public String toString() {
    return value;
  }
}
