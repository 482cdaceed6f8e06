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

/** The policy server of a run with mode &#x60;push&#x60;, with what was left open filled in, and without its key. */
public class PolicyServerView {
  @SerializedName("url")
  @javax.annotation.Nonnull
  private String url;

  @SerializedName("protocol")
  @javax.annotation.Nonnull
  private String protocol;

  @SerializedName("has_api_key")
  @javax.annotation.Nonnull
  private Boolean hasApiKey;

  @SerializedName("model")
  private String model;

  @SerializedName("call_timeout_s")
  @javax.annotation.Nonnull
  private Double callTimeoutS;

  @SerializedName("max_concurrent")
  @javax.annotation.Nonnull
  private Integer maxConcurrent;

  @SerializedName("max_retries")
  @javax.annotation.Nonnull
  private Integer maxRetries;

  @SerializedName("generation")
  private Map<String, Double> generation;

  public String getUrl() {
    return url;
  }

  public PolicyServerView url(String url) {
    this.url = url;
    return this;
  }

  public void setUrl(String url) {
    this.url = url;
  }

  /** A &#x60;PolicyProtocol&#x60;, or one of a later version. */
  public String getProtocol() {
    return protocol;
  }

  public PolicyServerView protocol(String protocol) {
    this.protocol = protocol;
    return this;
  }

  public void setProtocol(String protocol) {
    this.protocol = protocol;
  }

  public Boolean getHasApiKey() {
    return hasApiKey;
  }

  public PolicyServerView hasApiKey(Boolean hasApiKey) {
    this.hasApiKey = hasApiKey;
    return this;
  }

  public void setHasApiKey(Boolean hasApiKey) {
    this.hasApiKey = hasApiKey;
  }

  public String getModel() {
    return model;
  }

  public PolicyServerView model(String model) {
    this.model = model;
    return this;
  }

  public void setModel(String model) {
    this.model = model;
  }

  public Double getCallTimeoutS() {
    return callTimeoutS;
  }

  public PolicyServerView callTimeoutS(Double callTimeoutS) {
    this.callTimeoutS = callTimeoutS;
    return this;
  }

  public void setCallTimeoutS(Double callTimeoutS) {
    this.callTimeoutS = callTimeoutS;
  }

  public Integer getMaxConcurrent() {
    return maxConcurrent;
  }

  public PolicyServerView maxConcurrent(Integer maxConcurrent) {
    this.maxConcurrent = maxConcurrent;
    return this;
  }

  public void setMaxConcurrent(Integer maxConcurrent) {
    this.maxConcurrent = maxConcurrent;
  }

  public Integer getMaxRetries() {
    return maxRetries;
  }

  public PolicyServerView maxRetries(Integer maxRetries) {
    this.maxRetries = maxRetries;
    return this;
  }

  public void setMaxRetries(Integer maxRetries) {
    this.maxRetries = maxRetries;
  }

  public Map<String, Double> getGeneration() {
    return generation;
  }

  public PolicyServerView generation(Map<String, Double> generation) {
    this.generation = generation;
    return this;
  }

  public void setGeneration(Map<String, Double> generation) {
    this.generation = generation;
  }

  public static PolicyServerView fromJson(String text) {
    return JSON.getGson().fromJson(text, PolicyServerView.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
