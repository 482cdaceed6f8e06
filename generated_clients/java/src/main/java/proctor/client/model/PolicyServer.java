/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */


package proctor.client.model;

import com.google.gson.annotations.SerializedName;
import java.time.OffsetDateTime;
import java.util.List;
import java.util.Map;
import java.util.Set;
import proctor.client.JSON;

/** Where the server finds the policy of a run with mode &#x60;push&#x60;, and how it calls it. */
public class PolicyServer {
  @SerializedName("url")
  @javax.annotation.Nonnull
  private String url;

  @SerializedName("protocol")
  @javax.annotation.Nonnull
  private PolicyProtocol protocol;

  @SerializedName("api_key")
  private String apiKey;

  @SerializedName("model")
  private String model;

  @SerializedName("call_timeout_s")
  private Double callTimeoutS;

  @SerializedName("max_concurrent")
  private Integer maxConcurrent;

  @SerializedName("max_retries")
  private Integer maxRetries;

  @SerializedName("generation")
  private Map<String, Double> generation;

  /** Base URL, without user, query or fragment; the path of an operation is appended to it. */
  public String getUrl() {
    return url;
  }

  public PolicyServer url(String url) {
    this.url = url;
    return this;
  }

  public void setUrl(String url) {
    this.url = url;
  }

  public PolicyProtocol getProtocol() {
    return protocol;
  }

  public PolicyServer protocol(PolicyProtocol protocol) {
    this.protocol = protocol;
    return this;
  }

  public void setProtocol(PolicyProtocol protocol) {
    this.protocol = protocol;
  }

  /** Sent as bearer token with every call, and never shown. */
  public String getApiKey() {
    return apiKey;
  }

  public PolicyServer apiKey(String apiKey) {
    this.apiKey = apiKey;
    return this;
  }

  public void setApiKey(String apiKey) {
    this.apiKey = apiKey;
  }

  /** Which model is asked, where a protocol knows several. */
  public String getModel() {
    return model;
  }

  public PolicyServer model(String model) {
    this.model = model;
    return this;
  }

  public void setModel(String model) {
    this.model = model;
  }

  /** Time for one call, from connecting to the last byte of its answer; 30 when absent. */
  public Double getCallTimeoutS() {
    return callTimeoutS;
  }

  public PolicyServer callTimeoutS(Double callTimeoutS) {
    this.callTimeoutS = callTimeoutS;
    return this;
  }

  public void setCallTimeoutS(Double callTimeoutS) {
    this.callTimeoutS = callTimeoutS;
  }

  /** Most episodes played and calls made at a time; as many as the policy, the run and the server allow when absent. */
  public Integer getMaxConcurrent() {
    return maxConcurrent;
  }

  public PolicyServer maxConcurrent(Integer maxConcurrent) {
    this.maxConcurrent = maxConcurrent;
    return this;
  }

  public void setMaxConcurrent(Integer maxConcurrent) {
    this.maxConcurrent = maxConcurrent;
  }

  /** How often a call that was not answered is repeated; 3 when absent. */
  public Integer getMaxRetries() {
    return maxRetries;
  }

  public PolicyServer maxRetries(Integer maxRetries) {
    this.maxRetries = maxRetries;
    return this;
  }

  public void setMaxRetries(Integer maxRetries) {
    this.maxRetries = maxRetries;
  }

  /** Numbers that a chat completion is asked with, such as &#x60;temperature&#x60; and &#x60;max_tokens&#x60;; for &#x60;openai_chat&#x60; and &#x60;openai_completions&#x60; alone. */
  public Map<String, Double> getGeneration() {
    return generation;
  }

  public PolicyServer generation(Map<String, Double> generation) {
    this.generation = generation;
    return this;
  }

  public void setGeneration(Map<String, Double> generation) {
    this.generation = generation;
  }

  public static PolicyServer fromJson(String text) {
    return JSON.getGson().fromJson(text, PolicyServer.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
