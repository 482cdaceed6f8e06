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

public class Heartbeat {
  @SerializedName("session_id")
  @javax.annotation.Nonnull
  private String sessionId;

  public String getSessionId() {
    return sessionId;
  }

  public Heartbeat sessionId(String sessionId) {
    this.sessionId = sessionId;
    return this;
  }

  public void setSessionId(String sessionId) {
    this.sessionId = sessionId;
  }

  public static Heartbeat fromJson(String text) {
    return JSON.getGson().fromJson(text, Heartbeat.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
