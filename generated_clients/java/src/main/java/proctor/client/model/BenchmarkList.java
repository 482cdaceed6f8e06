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

public class BenchmarkList {
  @SerializedName("benchmarks")
  @javax.annotation.Nonnull
  private List<BenchmarkSummary> benchmarks;

  public List<BenchmarkSummary> getBenchmarks() {
    return benchmarks;
  }

  public BenchmarkList benchmarks(List<BenchmarkSummary> benchmarks) {
    this.benchmarks = benchmarks;
    return this;
  }

  public void setBenchmarks(List<BenchmarkSummary> benchmarks) {
    this.benchmarks = benchmarks;
  }

  public static BenchmarkList fromJson(String text) {
    return JSON.getGson().fromJson(text, BenchmarkList.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
