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

public class AttachWorker {
  @SerializedName("attach_key")
  @javax.annotation.Nonnull
  private String attachKey;

  @SerializedName("takeover")
  private Boolean takeover;

  @SerializedName("assumes")
  private Assumptions assumes;

  @SerializedName("player")
  private Player player;

  /** New for every attachment; repeated only to repeat a lost request. */
  public String getAttachKey() {
    return attachKey;
  }

  public AttachWorker attachKey(String attachKey) {
    this.attachKey = attachKey;
    return this;
  }

  public void setAttachKey(String attachKey) {
    this.attachKey = attachKey;
  }

  /** Fence out a live session; false when absent. */
  public Boolean getTakeover() {
    return takeover;
  }

  public AttachWorker takeover(Boolean takeover) {
    this.takeover = takeover;
    return this;
  }

  public void setTakeover(Boolean takeover) {
    this.takeover = takeover;
  }

  public Assumptions getAssumes() {
    return assumes;
  }

  public AttachWorker assumes(Assumptions assumes) {
    this.assumes = assumes;
    return this;
  }

  public void setAssumes(Assumptions assumes) {
    this.assumes = assumes;
  }

  public Player getPlayer() {
    return player;
  }

  public AttachWorker player(Player player) {
    this.player = player;
    return this;
  }

  public void setPlayer(Player player) {
    this.player = player;
  }

  public static AttachWorker fromJson(String text) {
    return JSON.getGson().fromJson(text, AttachWorker.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
