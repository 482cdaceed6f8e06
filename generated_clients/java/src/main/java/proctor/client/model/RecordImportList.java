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

public class RecordImportList {
  @SerializedName("imports")
  @javax.annotation.Nonnull
  private List<RecordImport> imports;

  @SerializedName("next_cursor")
  private String nextCursor;

  public List<RecordImport> getImports() {
    return imports;
  }

  public RecordImportList imports(List<RecordImport> imports) {
    this.imports = imports;
    return this;
  }

  public void setImports(List<RecordImport> imports) {
    this.imports = imports;
  }

  public String getNextCursor() {
    return nextCursor;
  }

  public RecordImportList nextCursor(String nextCursor) {
    this.nextCursor = nextCursor;
    return this;
  }

  public void setNextCursor(String nextCursor) {
    this.nextCursor = nextCursor;
  }

  public static RecordImportList fromJson(String text) {
    return JSON.getGson().fromJson(text, RecordImportList.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
