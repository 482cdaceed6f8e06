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

public class Predict {
  @SerializedName("session_id")
  @javax.annotation.Nonnull
  private String sessionId;

  @SerializedName("seq")
  @javax.annotation.Nonnull
  private Long seq;

  @SerializedName("actions")
  @javax.annotation.Nonnull
  private List<Action> actions;

  @SerializedName("observe")
  private Observe observe;

  public String getSessionId() {
    return sessionId;
  }

  public Predict sessionId(String sessionId) {
    this.sessionId = sessionId;
    return this;
  }

  public void setSessionId(String sessionId) {
    this.sessionId = sessionId;
  }

  public Long getSeq() {
    return seq;
  }

  public Predict seq(Long seq) {
    this.seq = seq;
    return this;
  }

  public void setSeq(Long seq) {
    this.seq = seq;
  }

  public List<Action> getActions() {
    return actions;
  }

  public Predict actions(List<Action> actions) {
    this.actions = actions;
    return this;
  }

  public void setActions(List<Action> actions) {
    this.actions = actions;
  }

  public Observe getObserve() {
    return observe;
  }

  public Predict observe(Observe observe) {
    this.observe = observe;
    return this;
  }

  public void setObserve(Observe observe) {
    this.observe = observe;
  }

  public static Predict fromJson(String text) {
    return JSON.getGson().fromJson(text, Predict.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
