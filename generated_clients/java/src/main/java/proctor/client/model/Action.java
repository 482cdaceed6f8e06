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

public class Action {
  @SerializedName("values")
  @javax.annotation.Nonnull
  private Map<String, List<Double>> values;

  /** Name → vector, exactly the entries of the benchmark&#39;s action space. */
  public Map<String, List<Double>> getValues() {
    return values;
  }

  public Action values(Map<String, List<Double>> values) {
    this.values = values;
    return this;
  }

  public void setValues(Map<String, List<Double>> values) {
    this.values = values;
  }

  public static Action fromJson(String text) {
    return JSON.getGson().fromJson(text, Action.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
