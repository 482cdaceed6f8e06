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

public class BenchmarkSummary {
  @SerializedName("benchmark_id")
  @javax.annotation.Nonnull
  private String benchmarkId;

  @SerializedName("version")
  @javax.annotation.Nonnull
  private String version;

  @SerializedName("title")
  @javax.annotation.Nonnull
  private String title;

  @SerializedName("manifest_sha256")
  @javax.annotation.Nonnull
  private String manifestSha256;

  @SerializedName("episodes_total")
  @javax.annotation.Nonnull
  private Integer episodesTotal;

  public String getBenchmarkId() {
    return benchmarkId;
  }

  public BenchmarkSummary benchmarkId(String benchmarkId) {
    this.benchmarkId = benchmarkId;
    return this;
  }

  public void setBenchmarkId(String benchmarkId) {
    this.benchmarkId = benchmarkId;
  }

  public String getVersion() {
    return version;
  }

  public BenchmarkSummary version(String version) {
    this.version = version;
    return this;
  }

  public void setVersion(String version) {
    this.version = version;
  }

  public String getTitle() {
    return title;
  }

  public BenchmarkSummary title(String title) {
    this.title = title;
    return this;
  }

  public void setTitle(String title) {
    this.title = title;
  }

  /** The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software. */
  public String getManifestSha256() {
    return manifestSha256;
  }

  public BenchmarkSummary manifestSha256(String manifestSha256) {
    this.manifestSha256 = manifestSha256;
    return this;
  }

  public void setManifestSha256(String manifestSha256) {
    this.manifestSha256 = manifestSha256;
  }

  public Integer getEpisodesTotal() {
    return episodesTotal;
  }

  public BenchmarkSummary episodesTotal(Integer episodesTotal) {
    this.episodesTotal = episodesTotal;
    return this;
  }

  public void setEpisodesTotal(Integer episodesTotal) {
    this.episodesTotal = episodesTotal;
  }

  public static BenchmarkSummary fromJson(String text) {
    return JSON.getGson().fromJson(text, BenchmarkSummary.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
