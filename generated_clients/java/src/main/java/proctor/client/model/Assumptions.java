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

/** What the policy takes for granted; refused when the benchmark says otherwise (ATT-010). */
public class Assumptions {
  @SerializedName("control_rate_hz")
  private Double controlRateHz;

  @SerializedName("action")
  private Map<String, Assumption> action;

  @SerializedName("state")
  private Map<String, Assumption> state;

  public Double getControlRateHz() {
    return controlRateHz;
  }

  public Assumptions controlRateHz(Double controlRateHz) {
    this.controlRateHz = controlRateHz;
    return this;
  }

  public void setControlRateHz(Double controlRateHz) {
    this.controlRateHz = controlRateHz;
  }

  public Map<String, Assumption> getAction() {
    return action;
  }

  public Assumptions action(Map<String, Assumption> action) {
    this.action = action;
    return this;
  }

  public void setAction(Map<String, Assumption> action) {
    this.action = action;
  }

  public Map<String, Assumption> getState() {
    return state;
  }

  public Assumptions state(Map<String, Assumption> state) {
    this.state = state;
    return this;
  }

  public void setState(Map<String, Assumption> state) {
    this.state = state;
  }

  public static Assumptions fromJson(String text) {
    return JSON.getGson().fromJson(text, Assumptions.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
