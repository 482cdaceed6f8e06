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

/** A record that was handed in, and what is known of it here. */
public class RecordImport {
  @SerializedName("import_id")
  @javax.annotation.Nonnull
  private String importId;

  @SerializedName("state")
  @javax.annotation.Nonnull
  private String state;

  @SerializedName("level")
  @javax.annotation.Nonnull
  private String level;

  @SerializedName("level_text")
  @javax.annotation.Nonnull
  private String levelText;

  @SerializedName("signer")
  private String signer;

  @SerializedName("keyid")
  @javax.annotation.Nonnull
  private String keyid;

  @SerializedName("archive_sha256")
  @javax.annotation.Nonnull
  private String archiveSha256;

  @SerializedName("statement_sha256")
  @javax.annotation.Nonnull
  private String statementSha256;

  @SerializedName("size_bytes")
  @javax.annotation.Nonnull
  private Long sizeBytes;

  @SerializedName("run_id")
  @javax.annotation.Nonnull
  private String runId;

  @SerializedName("benchmark_id")
  @javax.annotation.Nonnull
  private String benchmarkId;

  @SerializedName("benchmark_version")
  @javax.annotation.Nonnull
  private String benchmarkVersion;

  @SerializedName("manifest_sha256")
  @javax.annotation.Nonnull
  private String manifestSha256;

  @SerializedName("policy")
  @javax.annotation.Nonnull
  private ImportedPolicy policy;

  @SerializedName("score")
  private Double score;

  @SerializedName("episodes")
  @javax.annotation.Nonnull
  private Integer episodes;

  @SerializedName("episodes_replayed")
  @javax.annotation.Nonnull
  private Integer episodesReplayed;

  @SerializedName("replay")
  private RecordReplay replay;

  @SerializedName("reason")
  private String reason;

  @SerializedName("imported_at")
  @javax.annotation.Nonnull
  private OffsetDateTime importedAt;

  @SerializedName("finished_at")
  private OffsetDateTime finishedAt;

  public String getImportId() {
    return importId;
  }

  public RecordImport importId(String importId) {
    this.importId = importId;
    return this;
  }

  public void setImportId(String importId) {
    this.importId = importId;
  }

  /** &#x60;waiting&#x60; for simulators, &#x60;replaying&#x60;, or &#x60;finished&#x60;. */
  public String getState() {
    return state;
  }

  public RecordImport state(String state) {
    this.state = state;
    return this;
  }

  public void setState(String state) {
    this.state = state;
  }

  /** &#x60;reported&#x60;: whole, by anyone; &#x60;signed&#x60; by a key that this server knows; &#x60;replayed&#x60; here with the same results; &#x60;diverged&#x60;: the replay came out otherwise. */
  public String getLevel() {
    return level;
  }

  public RecordImport level(String level) {
    this.level = level;
    return this;
  }

  public void setLevel(String level) {
    this.level = level;
  }

  /** The level with who says it, as REC-031 has it. */
  public String getLevelText() {
    return levelText;
  }

  public RecordImport levelText(String levelText) {
    this.levelText = levelText;
    return this;
  }

  public void setLevelText(String levelText) {
    this.levelText = levelText;
  }

  /** Whose key signed the record, as this server knows it; null for a key that it does not know. */
  public String getSigner() {
    return signer;
  }

  public RecordImport signer(String signer) {
    this.signer = signer;
    return this;
  }

  public void setSigner(String signer) {
    this.signer = signer;
  }

  /** Of the key that signed the record. */
  public String getKeyid() {
    return keyid;
  }

  public RecordImport keyid(String keyid) {
    this.keyid = keyid;
    return this;
  }

  public void setKeyid(String keyid) {
    this.keyid = keyid;
  }

  public String getArchiveSha256() {
    return archiveSha256;
  }

  public RecordImport archiveSha256(String archiveSha256) {
    this.archiveSha256 = archiveSha256;
    return this;
  }

  public void setArchiveSha256(String archiveSha256) {
    this.archiveSha256 = archiveSha256;
  }

  public String getStatementSha256() {
    return statementSha256;
  }

  public RecordImport statementSha256(String statementSha256) {
    this.statementSha256 = statementSha256;
    return this;
  }

  public void setStatementSha256(String statementSha256) {
    this.statementSha256 = statementSha256;
  }

  public Long getSizeBytes() {
    return sizeBytes;
  }

  public RecordImport sizeBytes(Long sizeBytes) {
    this.sizeBytes = sizeBytes;
    return this;
  }

  public void setSizeBytes(Long sizeBytes) {
    this.sizeBytes = sizeBytes;
  }

  /** In the statement, as are the members below it. */
  public String getRunId() {
    return runId;
  }

  public RecordImport runId(String runId) {
    this.runId = runId;
    return this;
  }

  public void setRunId(String runId) {
    this.runId = runId;
  }

  public String getBenchmarkId() {
    return benchmarkId;
  }

  public RecordImport benchmarkId(String benchmarkId) {
    this.benchmarkId = benchmarkId;
    return this;
  }

  public void setBenchmarkId(String benchmarkId) {
    this.benchmarkId = benchmarkId;
  }

  public String getBenchmarkVersion() {
    return benchmarkVersion;
  }

  public RecordImport benchmarkVersion(String benchmarkVersion) {
    this.benchmarkVersion = benchmarkVersion;
    return this;
  }

  public void setBenchmarkVersion(String benchmarkVersion) {
    this.benchmarkVersion = benchmarkVersion;
  }

  public String getManifestSha256() {
    return manifestSha256;
  }

  public RecordImport manifestSha256(String manifestSha256) {
    this.manifestSha256 = manifestSha256;
    return this;
  }

  public void setManifestSha256(String manifestSha256) {
    this.manifestSha256 = manifestSha256;
  }

  public ImportedPolicy getPolicy() {
    return policy;
  }

  public RecordImport policy(ImportedPolicy policy) {
    this.policy = policy;
    return this;
  }

  public void setPolicy(ImportedPolicy policy) {
    this.policy = policy;
  }

  /** Null where an episode has no result. */
  public Double getScore() {
    return score;
  }

  public RecordImport score(Double score) {
    this.score = score;
    return this;
  }

  public void setScore(Double score) {
    this.score = score;
  }

  public Integer getEpisodes() {
    return episodes;
  }

  public RecordImport episodes(Integer episodes) {
    this.episodes = episodes;
    return this;
  }

  public void setEpisodes(Integer episodes) {
    this.episodes = episodes;
  }

  /** How many of them were simulated so far. */
  public Integer getEpisodesReplayed() {
    return episodesReplayed;
  }

  public RecordImport episodesReplayed(Integer episodesReplayed) {
    this.episodesReplayed = episodesReplayed;
    return this;
  }

  public void setEpisodesReplayed(Integer episodesReplayed) {
    this.episodesReplayed = episodesReplayed;
  }

  public RecordReplay getReplay() {
    return replay;
  }

  public RecordImport replay(RecordReplay replay) {
    this.replay = replay;
    return this;
  }

  public void setReplay(RecordReplay replay) {
    this.replay = replay;
  }

  /** Why there is no replay. */
  public String getReason() {
    return reason;
  }

  public RecordImport reason(String reason) {
    this.reason = reason;
    return this;
  }

  public void setReason(String reason) {
    this.reason = reason;
  }

  public OffsetDateTime getImportedAt() {
    return importedAt;
  }

  public RecordImport importedAt(OffsetDateTime importedAt) {
    this.importedAt = importedAt;
    return this;
  }

  public void setImportedAt(OffsetDateTime importedAt) {
    this.importedAt = importedAt;
  }

  public OffsetDateTime getFinishedAt() {
    return finishedAt;
  }

  public RecordImport finishedAt(OffsetDateTime finishedAt) {
    this.finishedAt = finishedAt;
    return this;
  }

  public void setFinishedAt(OffsetDateTime finishedAt) {
    this.finishedAt = finishedAt;
  }

  public static RecordImport fromJson(String text) {
    return JSON.getGson().fromJson(text, RecordImport.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
