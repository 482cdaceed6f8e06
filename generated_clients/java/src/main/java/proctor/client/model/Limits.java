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

public class Limits {
  @SerializedName("max_body_bytes")
  @javax.annotation.Nonnull
  private Long maxBodyBytes;

  @SerializedName("max_workers")
  @javax.annotation.Nonnull
  private Integer maxWorkers;

  @SerializedName("max_chunk")
  @javax.annotation.Nonnull
  private Integer maxChunk;

  @SerializedName("idle_timeout_s_min")
  @javax.annotation.Nonnull
  private Double idleTimeoutSMin;

  @SerializedName("idle_timeout_s_max")
  @javax.annotation.Nonnull
  private Double idleTimeoutSMax;

  @SerializedName("wait_s_max")
  @javax.annotation.Nonnull
  private Integer waitSMax;

  @SerializedName("max_header_bytes")
  private Integer maxHeaderBytes;

  @SerializedName("header_timeout_s")
  private Double headerTimeoutS;

  @SerializedName("body_timeout_s")
  private Double bodyTimeoutS;

  @SerializedName("heartbeat_s_max")
  private Double heartbeatSMax;

  @SerializedName("unused_s_max")
  private Double unusedSMax;

  @SerializedName("max_control_body_bytes")
  private Long maxControlBodyBytes;

  @SerializedName("max_open_runs")
  private Integer maxOpenRuns;

  @SerializedName("max_idempotency_keys")
  private Long maxIdempotencyKeys;

  @SerializedName("max_stored_bytes")
  private Long maxStoredBytes;

  @SerializedName("max_record_bytes")
  private Long maxRecordBytes;

  @SerializedName("max_waiting_imports")
  private Integer maxWaitingImports;

  @SerializedName("max_imported_bytes")
  private Long maxImportedBytes;

  @SerializedName("run_keep_days")
  private Double runKeepDays;

  /** Longest request body that is read. */
  public Long getMaxBodyBytes() {
    return maxBodyBytes;
  }

  public Limits maxBodyBytes(Long maxBodyBytes) {
    this.maxBodyBytes = maxBodyBytes;
    return this;
  }

  public void setMaxBodyBytes(Long maxBodyBytes) {
    this.maxBodyBytes = maxBodyBytes;
  }

  /** Most live workers a run may ask for. */
  public Integer getMaxWorkers() {
    return maxWorkers;
  }

  public Limits maxWorkers(Integer maxWorkers) {
    this.maxWorkers = maxWorkers;
    return this;
  }

  public void setMaxWorkers(Integer maxWorkers) {
    this.maxWorkers = maxWorkers;
  }

  /** Most actions in one predict; a benchmark may allow fewer. */
  public Integer getMaxChunk() {
    return maxChunk;
  }

  public Limits maxChunk(Integer maxChunk) {
    this.maxChunk = maxChunk;
    return this;
  }

  public void setMaxChunk(Integer maxChunk) {
    this.maxChunk = maxChunk;
  }

  public Double getIdleTimeoutSMin() {
    return idleTimeoutSMin;
  }

  public Limits idleTimeoutSMin(Double idleTimeoutSMin) {
    this.idleTimeoutSMin = idleTimeoutSMin;
    return this;
  }

  public void setIdleTimeoutSMin(Double idleTimeoutSMin) {
    this.idleTimeoutSMin = idleTimeoutSMin;
  }

  public Double getIdleTimeoutSMax() {
    return idleTimeoutSMax;
  }

  public Limits idleTimeoutSMax(Double idleTimeoutSMax) {
    this.idleTimeoutSMax = idleTimeoutSMax;
    return this;
  }

  public void setIdleTimeoutSMax(Double idleTimeoutSMax) {
    this.idleTimeoutSMax = idleTimeoutSMax;
  }

  /** Longest wait that a long-poll is granted. */
  public Integer getWaitSMax() {
    return waitSMax;
  }

  public Limits waitSMax(Integer waitSMax) {
    this.waitSMax = waitSMax;
    return this;
  }

  public void setWaitSMax(Integer waitSMax) {
    this.waitSMax = waitSMax;
  }

  /** Longest request line with its headers that is read; for the profile &#x60;limits&#x60;. */
  public Integer getMaxHeaderBytes() {
    return maxHeaderBytes;
  }

  public Limits maxHeaderBytes(Integer maxHeaderBytes) {
    this.maxHeaderBytes = maxHeaderBytes;
    return this;
  }

  public void setMaxHeaderBytes(Integer maxHeaderBytes) {
    this.maxHeaderBytes = maxHeaderBytes;
  }

  /** Time in which the headers of a request are complete, from its first byte; for the profile &#x60;limits&#x60;. */
  public Double getHeaderTimeoutS() {
    return headerTimeoutS;
  }

  public Limits headerTimeoutS(Double headerTimeoutS) {
    this.headerTimeoutS = headerTimeoutS;
    return this;
  }

  public void setHeaderTimeoutS(Double headerTimeoutS) {
    this.headerTimeoutS = headerTimeoutS;
  }

  /** Time in which a part of a body arrives after the headers of its request; for the profile &#x60;limits&#x60;. */
  public Double getBodyTimeoutS() {
    return bodyTimeoutS;
  }

  public Limits bodyTimeoutS(Double bodyTimeoutS) {
    this.bodyTimeoutS = bodyTimeoutS;
    return this;
  }

  public void setBodyTimeoutS(Double bodyTimeoutS) {
    this.bodyTimeoutS = bodyTimeoutS;
  }

  /** Longest time that a session lives without a new turn, whatever its &#x60;idle_timeout_s&#x60;; for the profile &#x60;limits&#x60;. */
  public Double getHeartbeatSMax() {
    return heartbeatSMax;
  }

  public Limits heartbeatSMax(Double heartbeatSMax) {
    this.heartbeatSMax = heartbeatSMax;
    return this;
  }

  public void setHeartbeatSMax(Double heartbeatSMax) {
    this.heartbeatSMax = heartbeatSMax;
  }

  /** When others wait: the time after which a run without a worker, or a session without a turn, may make room; for the profile &#x60;limits&#x60;. */
  public Double getUnusedSMax() {
    return unusedSMax;
  }

  public Limits unusedSMax(Double unusedSMax) {
    this.unusedSMax = unusedSMax;
    return this;
  }

  public void setUnusedSMax(Double unusedSMax) {
    this.unusedSMax = unusedSMax;
  }

  /** Longest body that is read of a request other than &#x60;predict&#x60;, where it is less than &#x60;max_body_bytes&#x60;; for the profile &#x60;limits&#x60;. */
  public Long getMaxControlBodyBytes() {
    return maxControlBodyBytes;
  }

  public Limits maxControlBodyBytes(Long maxControlBodyBytes) {
    this.maxControlBodyBytes = maxControlBodyBytes;
    return this;
  }

  public void setMaxControlBodyBytes(Long maxControlBodyBytes) {
    this.maxControlBodyBytes = maxControlBodyBytes;
  }

  /** Most runs of one account that are queued, ready, running or stopping; for the profile &#x60;limits&#x60;. */
  public Integer getMaxOpenRuns() {
    return maxOpenRuns;
  }

  public Limits maxOpenRuns(Integer maxOpenRuns) {
    this.maxOpenRuns = maxOpenRuns;
    return this;
  }

  public void setMaxOpenRuns(Integer maxOpenRuns) {
    this.maxOpenRuns = maxOpenRuns;
  }

  /** Most Idempotency-Keys that one account may use; for the profile &#x60;limits&#x60;. */
  public Long getMaxIdempotencyKeys() {
    return maxIdempotencyKeys;
  }

  public Limits maxIdempotencyKeys(Long maxIdempotencyKeys) {
    this.maxIdempotencyKeys = maxIdempotencyKeys;
    return this;
  }

  public void setMaxIdempotencyKeys(Long maxIdempotencyKeys) {
    this.maxIdempotencyKeys = maxIdempotencyKeys;
  }

  /** Most bytes that the submissions of one account may have together; what else a server stores for a run may count, too. For the profile &#x60;limits&#x60;. */
  public Long getMaxStoredBytes() {
    return maxStoredBytes;
  }

  public Limits maxStoredBytes(Long maxStoredBytes) {
    this.maxStoredBytes = maxStoredBytes;
    return this;
  }

  public void setMaxStoredBytes(Long maxStoredBytes) {
    this.maxStoredBytes = maxStoredBytes;
  }

  /** Longest archive that &#x60;import_record&#x60; reads; for the profile &#x60;record_import&#x60;. */
  public Long getMaxRecordBytes() {
    return maxRecordBytes;
  }

  public Limits maxRecordBytes(Long maxRecordBytes) {
    this.maxRecordBytes = maxRecordBytes;
    return this;
  }

  public void setMaxRecordBytes(Long maxRecordBytes) {
    this.maxRecordBytes = maxRecordBytes;
  }

  /** Most imports of one account that are not &#x60;finished&#x60;; for the profile &#x60;record_import&#x60;. */
  public Integer getMaxWaitingImports() {
    return maxWaitingImports;
  }

  public Limits maxWaitingImports(Integer maxWaitingImports) {
    this.maxWaitingImports = maxWaitingImports;
    return this;
  }

  public void setMaxWaitingImports(Integer maxWaitingImports) {
    this.maxWaitingImports = maxWaitingImports;
  }

  /** Most bytes that the archives of one account may have together; for the profile &#x60;record_import&#x60;. */
  public Long getMaxImportedBytes() {
    return maxImportedBytes;
  }

  public Limits maxImportedBytes(Long maxImportedBytes) {
    this.maxImportedBytes = maxImportedBytes;
    return this;
  }

  public void setMaxImportedBytes(Long maxImportedBytes) {
    this.maxImportedBytes = maxImportedBytes;
  }

  /** Days without a change after which a run that has completed, failed or been stopped may be deleted; when absent, none is. For the profile &#x60;deletion&#x60;. */
  public Double getRunKeepDays() {
    return runKeepDays;
  }

  public Limits runKeepDays(Double runKeepDays) {
    this.runKeepDays = runKeepDays;
    return this;
  }

  public void setRunKeepDays(Double runKeepDays) {
    this.runKeepDays = runKeepDays;
  }

  public static Limits fromJson(String text) {
    return JSON.getGson().fromJson(text, Limits.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
