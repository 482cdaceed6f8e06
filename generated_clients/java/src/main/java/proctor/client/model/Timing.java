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

/** Server time of this turn, in seconds. */
public class Timing {
  @SerializedName("total_s")
  @javax.annotation.Nonnull
  private Double totalS;

  @SerializedName("queue_s")
  @javax.annotation.Nonnull
  private Double queueS;

  @SerializedName("simulate_s")
  @javax.annotation.Nonnull
  private Double simulateS;

  @SerializedName("render_s")
  @javax.annotation.Nonnull
  private Double renderS;

  @SerializedName("encode_s")
  @javax.annotation.Nonnull
  private Double encodeS;

  public Double getTotalS() {
    return totalS;
  }

  public Timing totalS(Double totalS) {
    this.totalS = totalS;
    return this;
  }

  public void setTotalS(Double totalS) {
    this.totalS = totalS;
  }

  public Double getQueueS() {
    return queueS;
  }

  public Timing queueS(Double queueS) {
    this.queueS = queueS;
    return this;
  }

  public void setQueueS(Double queueS) {
    this.queueS = queueS;
  }

  public Double getSimulateS() {
    return simulateS;
  }

  public Timing simulateS(Double simulateS) {
    this.simulateS = simulateS;
    return this;
  }

  public void setSimulateS(Double simulateS) {
    this.simulateS = simulateS;
  }

  public Double getRenderS() {
    return renderS;
  }

  public Timing renderS(Double renderS) {
    this.renderS = renderS;
    return this;
  }

  public void setRenderS(Double renderS) {
    this.renderS = renderS;
  }

  /** Encoding of images. */
  public Double getEncodeS() {
    return encodeS;
  }

  public Timing encodeS(Double encodeS) {
    this.encodeS = encodeS;
    return this;
  }

  public void setEncodeS(Double encodeS) {
    this.encodeS = encodeS;
  }

  public static Timing fromJson(String text) {
    return JSON.getGson().fromJson(text, Timing.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
