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

/** See scoring.md for every number here. */
public class Comparison {
  @SerializedName("baseline")
  @javax.annotation.Nonnull
  private String baseline;

  @SerializedName("benchmark_id")
  @javax.annotation.Nonnull
  private String benchmarkId;

  @SerializedName("manifest_sha256")
  @javax.annotation.Nonnull
  private String manifestSha256;

  @SerializedName("tolerance")
  @javax.annotation.Nonnull
  private Double tolerance;

  @SerializedName("runs")
  @javax.annotation.Nonnull
  private List<ComparedRun> runs;

  /** Id of the run that the others are compared with. */
  public String getBaseline() {
    return baseline;
  }

  public Comparison baseline(String baseline) {
    this.baseline = baseline;
    return this;
  }

  public void setBaseline(String baseline) {
    this.baseline = baseline;
  }

  public String getBenchmarkId() {
    return benchmarkId;
  }

  public Comparison benchmarkId(String benchmarkId) {
    this.benchmarkId = benchmarkId;
    return this;
  }

  public void setBenchmarkId(String benchmarkId) {
    this.benchmarkId = benchmarkId;
  }

  /** The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software. */
  public String getManifestSha256() {
    return manifestSha256;
  }

  public Comparison manifestSha256(String manifestSha256) {
    this.manifestSha256 = manifestSha256;
    return this;
  }

  public void setManifestSha256(String manifestSha256) {
    this.manifestSha256 = manifestSha256;
  }

  public Double getTolerance() {
    return tolerance;
  }

  public Comparison tolerance(Double tolerance) {
    this.tolerance = tolerance;
    return this;
  }

  public void setTolerance(Double tolerance) {
    this.tolerance = tolerance;
  }

  /** One entry per run that was named, in that order. */
  public List<ComparedRun> getRuns() {
    return runs;
  }

  public Comparison runs(List<ComparedRun> runs) {
    this.runs = runs;
    return this;
  }

  public void setRuns(List<ComparedRun> runs) {
    this.runs = runs;
  }

  public static Comparison fromJson(String text) {
    return JSON.getGson().fromJson(text, Comparison.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
