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

/** See board.md for every number here. */
public class Ranking {
  @SerializedName("benchmark_id")
  @javax.annotation.Nonnull
  private String benchmarkId;

  @SerializedName("manifest_sha256")
  @javax.annotation.Nonnull
  private String manifestSha256;

  @SerializedName("episodes_total")
  private Integer episodesTotal;

  @SerializedName("ranked")
  @javax.annotation.Nonnull
  private Integer ranked;

  @SerializedName("comparisons")
  @javax.annotation.Nonnull
  private Long comparisons;

  @SerializedName("alpha")
  @javax.annotation.Nonnull
  private Double alpha;

  @SerializedName("differing_min")
  private Integer differingMin;

  @SerializedName("differing_enough")
  private Integer differingEnough;

  @SerializedName("rows")
  @javax.annotation.Nonnull
  private List<RankedEntry> rows;

  @SerializedName("next_cursor")
  private String nextCursor;

  public String getBenchmarkId() {
    return benchmarkId;
  }

  public Ranking benchmarkId(String benchmarkId) {
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

  public Ranking manifestSha256(String manifestSha256) {
    this.manifestSha256 = manifestSha256;
    return this;
  }

  public void setManifestSha256(String manifestSha256) {
    this.manifestSha256 = manifestSha256;
  }

  /** How many episodes each entry has; null where the manifest has no entry. */
  public Integer getEpisodesTotal() {
    return episodesTotal;
  }

  public Ranking episodesTotal(Integer episodesTotal) {
    this.episodesTotal = episodesTotal;
    return this;
  }

  public void setEpisodesTotal(Integer episodesTotal) {
    this.episodesTotal = episodesTotal;
  }

  /** How many entries have a rank. */
  public Integer getRanked() {
    return ranked;
  }

  public Ranking ranked(Integer ranked) {
    this.ranked = ranked;
    return this;
  }

  public void setRanked(Integer ranked) {
    this.ranked = ranked;
  }

  /** How many pairs of them were tested. */
  public Long getComparisons() {
    return comparisons;
  }

  public Ranking comparisons(Long comparisons) {
    this.comparisons = comparisons;
    return this;
  }

  public void setComparisons(Long comparisons) {
    this.comparisons = comparisons;
  }

  /** How likely it is at most that any two equally good policies are distinguished; 0.05. */
  public Double getAlpha() {
    return alpha;
  }

  public Ranking alpha(Double alpha) {
    this.alpha = alpha;
    return this;
  }

  public void setAlpha(Double alpha) {
    this.alpha = alpha;
  }

  /** Two entries that differ on fewer episodes can never be distinguished; null if the benchmark has fewer episodes. */
  public Integer getDifferingMin() {
    return differingMin;
  }

  public Ranking differingMin(Integer differingMin) {
    this.differingMin = differingMin;
    return this;
  }

  public void setDifferingMin(Integer differingMin) {
    this.differingMin = differingMin;
  }

  /** Two entries that differ on so many episodes, all to the advantage of one, are distinguished, however the others fared; null if the benchmark has fewer episodes. */
  public Integer getDifferingEnough() {
    return differingEnough;
  }

  public Ranking differingEnough(Integer differingEnough) {
    this.differingEnough = differingEnough;
    return this;
  }

  public void setDifferingEnough(Integer differingEnough) {
    this.differingEnough = differingEnough;
  }

  public List<RankedEntry> getRows() {
    return rows;
  }

  public Ranking rows(List<RankedEntry> rows) {
    this.rows = rows;
    return this;
  }

  public void setRows(List<RankedEntry> rows) {
    this.rows = rows;
  }

  public String getNextCursor() {
    return nextCursor;
  }

  public Ranking nextCursor(String nextCursor) {
    this.nextCursor = nextCursor;
    return this;
  }

  public void setNextCursor(String nextCursor) {
    this.nextCursor = nextCursor;
  }

  public static Ranking fromJson(String text) {
    return JSON.getGson().fromJson(text, Ranking.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
