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

public class BoardEntry {
  @SerializedName("entry_id")
  @javax.annotation.Nonnull
  private String entryId;

  @SerializedName("run_id")
  @javax.annotation.Nonnull
  private String runId;

  @SerializedName("submitter")
  @javax.annotation.Nonnull
  private String submitter;

  @SerializedName("benchmark_id")
  @javax.annotation.Nonnull
  private String benchmarkId;

  @SerializedName("benchmark_version")
  @javax.annotation.Nonnull
  private String benchmarkVersion;

  @SerializedName("manifest_sha256")
  @javax.annotation.Nonnull
  private String manifestSha256;

  @SerializedName("select")
  private SelectionView select;

  @SerializedName("policy")
  @javax.annotation.Nonnull
  private PolicyInfo policy;

  @SerializedName("model_name")
  @javax.annotation.Nonnull
  private String modelName;

  @SerializedName("is_public")
  @javax.annotation.Nonnull
  private Boolean isPublic;

  @SerializedName("model_type")
  private String modelType;

  @SerializedName("organisation")
  private String organisation;

  @SerializedName("homepage")
  private String homepage;

  @SerializedName("code_url")
  private String codeUrl;

  @SerializedName("notes")
  private String notes;

  @SerializedName("state")
  @javax.annotation.Nonnull
  private String state;

  @SerializedName("flag")
  private EntryFlag flag;

  @SerializedName("level")
  @javax.annotation.Nonnull
  private String level;

  @SerializedName("attempts")
  @javax.annotation.Nonnull
  private Integer attempts;

  @SerializedName("score")
  @javax.annotation.Nonnull
  private EntryScore score;

  @SerializedName("published_at")
  @javax.annotation.Nonnull
  private OffsetDateTime publishedAt;

  @SerializedName("changed_at")
  @javax.annotation.Nonnull
  private OffsetDateTime changedAt;

  public String getEntryId() {
    return entryId;
  }

  public BoardEntry entryId(String entryId) {
    this.entryId = entryId;
    return this;
  }

  public void setEntryId(String entryId) {
    this.entryId = entryId;
  }

  public String getRunId() {
    return runId;
  }

  public BoardEntry runId(String runId) {
    this.runId = runId;
    return this;
  }

  public void setRunId(String runId) {
    this.runId = runId;
  }

  /** Name of the account that submitted the run. */
  public String getSubmitter() {
    return submitter;
  }

  public BoardEntry submitter(String submitter) {
    this.submitter = submitter;
    return this;
  }

  public void setSubmitter(String submitter) {
    this.submitter = submitter;
  }

  public String getBenchmarkId() {
    return benchmarkId;
  }

  public BoardEntry benchmarkId(String benchmarkId) {
    this.benchmarkId = benchmarkId;
    return this;
  }

  public void setBenchmarkId(String benchmarkId) {
    this.benchmarkId = benchmarkId;
  }

  public String getBenchmarkVersion() {
    return benchmarkVersion;
  }

  public BoardEntry benchmarkVersion(String benchmarkVersion) {
    this.benchmarkVersion = benchmarkVersion;
    return this;
  }

  public void setBenchmarkVersion(String benchmarkVersion) {
    this.benchmarkVersion = benchmarkVersion;
  }

  /** The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software. */
  public String getManifestSha256() {
    return manifestSha256;
  }

  public BoardEntry manifestSha256(String manifestSha256) {
    this.manifestSha256 = manifestSha256;
    return this;
  }

  public void setManifestSha256(String manifestSha256) {
    this.manifestSha256 = manifestSha256;
  }

  public SelectionView getSelect() {
    return select;
  }

  public BoardEntry select(SelectionView select) {
    this.select = select;
    return this;
  }

  public void setSelect(SelectionView select) {
    this.select = select;
  }

  public PolicyInfo getPolicy() {
    return policy;
  }

  public BoardEntry policy(PolicyInfo policy) {
    this.policy = policy;
    return this;
  }

  public void setPolicy(PolicyInfo policy) {
    this.policy = policy;
  }

  public String getModelName() {
    return modelName;
  }

  public BoardEntry modelName(String modelName) {
    this.modelName = modelName;
    return this;
  }

  public void setModelName(String modelName) {
    this.modelName = modelName;
  }

  public Boolean getIsPublic() {
    return isPublic;
  }

  public BoardEntry isPublic(Boolean isPublic) {
    this.isPublic = isPublic;
    return this;
  }

  public void setIsPublic(Boolean isPublic) {
    this.isPublic = isPublic;
  }

  public String getModelType() {
    return modelType;
  }

  public BoardEntry modelType(String modelType) {
    this.modelType = modelType;
    return this;
  }

  public void setModelType(String modelType) {
    this.modelType = modelType;
  }

  public String getOrganisation() {
    return organisation;
  }

  public BoardEntry organisation(String organisation) {
    this.organisation = organisation;
    return this;
  }

  public void setOrganisation(String organisation) {
    this.organisation = organisation;
  }

  public String getHomepage() {
    return homepage;
  }

  public BoardEntry homepage(String homepage) {
    this.homepage = homepage;
    return this;
  }

  public void setHomepage(String homepage) {
    this.homepage = homepage;
  }

  public String getCodeUrl() {
    return codeUrl;
  }

  public BoardEntry codeUrl(String codeUrl) {
    this.codeUrl = codeUrl;
    return this;
  }

  public void setCodeUrl(String codeUrl) {
    this.codeUrl = codeUrl;
  }

  public String getNotes() {
    return notes;
  }

  public BoardEntry notes(String notes) {
    this.notes = notes;
    return this;
  }

  public void setNotes(String notes) {
    this.notes = notes;
  }

  public String getState() {
    return state;
  }

  public BoardEntry state(String state) {
    this.state = state;
    return this;
  }

  public void setState(String state) {
    this.state = state;
  }

  public EntryFlag getFlag() {
    return flag;
  }

  public BoardEntry flag(EntryFlag flag) {
    this.flag = flag;
    return this;
  }

  public void setFlag(EntryFlag flag) {
    this.flag = flag;
  }

  /** What is known of the score: &#x60;reported&#x60; by the server alone; &#x60;signed&#x60;, for the run has a record that this host signs. */
  public String getLevel() {
    return level;
  }

  public BoardEntry level(String level) {
    this.level = level;
    return this;
  }

  public void setLevel(String level) {
    this.level = level;
  }

  /** How many runs of the benchmark the account has submitted until now, published or not. */
  public Integer getAttempts() {
    return attempts;
  }

  public BoardEntry attempts(Integer attempts) {
    this.attempts = attempts;
    return this;
  }

  public void setAttempts(Integer attempts) {
    this.attempts = attempts;
  }

  public EntryScore getScore() {
    return score;
  }

  public BoardEntry score(EntryScore score) {
    this.score = score;
    return this;
  }

  public void setScore(EntryScore score) {
    this.score = score;
  }

  public OffsetDateTime getPublishedAt() {
    return publishedAt;
  }

  public BoardEntry publishedAt(OffsetDateTime publishedAt) {
    this.publishedAt = publishedAt;
    return this;
  }

  public void setPublishedAt(OffsetDateTime publishedAt) {
    this.publishedAt = publishedAt;
  }

  /** When the description, the state or the flag changed for the last time. */
  public OffsetDateTime getChangedAt() {
    return changedAt;
  }

  public BoardEntry changedAt(OffsetDateTime changedAt) {
    this.changedAt = changedAt;
    return this;
  }

  public void setChangedAt(OffsetDateTime changedAt) {
    this.changedAt = changedAt;
  }

  public static BoardEntry fromJson(String text) {
    return JSON.getGson().fromJson(text, BoardEntry.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
