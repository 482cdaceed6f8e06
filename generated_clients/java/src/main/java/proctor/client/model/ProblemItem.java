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

public class ProblemItem {
  @SerializedName("pointer")
  @javax.annotation.Nonnull
  private String pointer;

  @SerializedName("detail")
  @javax.annotation.Nonnull
  private String detail;

  /** JSON pointer into the body, to the faulty member or a part of it; or &#x60;query:name&#x60;, &#x60;header:name&#x60;, &#x60;path:name&#x60;; or &#x60;record:name&#x60;, with the name of a file in a record. */
  public String getPointer() {
    return pointer;
  }

  public ProblemItem pointer(String pointer) {
    this.pointer = pointer;
    return this;
  }

  public void setPointer(String pointer) {
    this.pointer = pointer;
  }

  public String getDetail() {
    return detail;
  }

  public ProblemItem detail(String detail) {
    this.detail = detail;
    return this;
  }

  public void setDetail(String detail) {
    this.detail = detail;
  }

  public static ProblemItem fromJson(String text) {
    return JSON.getGson().fromJson(text, ProblemItem.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
