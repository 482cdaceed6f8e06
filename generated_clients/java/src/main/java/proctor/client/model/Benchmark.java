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

/** Everything about a benchmark that can change a score. */
public class Benchmark {
  @SerializedName("benchmark_id")
  @javax.annotation.Nonnull
  private String benchmarkId;

  @SerializedName("version")
  @javax.annotation.Nonnull
  private String version;

  @SerializedName("title")
  @javax.annotation.Nonnull
  private String title;

  @SerializedName("description")
  @javax.annotation.Nonnull
  private String description;

  @SerializedName("manifest_sha256")
  @javax.annotation.Nonnull
  private String manifestSha256;

  @SerializedName("episodes_total")
  @javax.annotation.Nonnull
  private Integer episodesTotal;

  @SerializedName("tasks")
  @javax.annotation.Nonnull
  private List<String> tasks;

  @SerializedName("splits")
  @javax.annotation.Nonnull
  private List<String> splits;

  @SerializedName("sealed_splits")
  private Set<String> sealedSplits;

  @SerializedName("seeds_sha256")
  private String seedsSha256;

  @SerializedName("control_rate_hz")
  @javax.annotation.Nonnull
  private Double controlRateHz;

  @SerializedName("max_steps")
  @javax.annotation.Nonnull
  private Integer maxSteps;

  @SerializedName("max_chunk")
  @javax.annotation.Nonnull
  private Integer maxChunk;

  @SerializedName("max_attempts")
  @javax.annotation.Nonnull
  private Integer maxAttempts;

  @SerializedName("max_faults")
  @javax.annotation.Nonnull
  private Integer maxFaults;

  @SerializedName("success_rule")
  @javax.annotation.Nonnull
  private String successRule;

  @SerializedName("action_space")
  @javax.annotation.Nonnull
  private Map<String, VectorSpace> actionSpace;

  @SerializedName("observation_space")
  @javax.annotation.Nonnull
  private ObservationSpace observationSpace;

  @SerializedName("image_sizes")
  @javax.annotation.Nonnull
  private List<ImageSize> imageSizes;

  @SerializedName("image_codecs")
  @javax.annotation.Nonnull
  private List<String> imageCodecs;

  @SerializedName("simulator")
  @javax.annotation.Nonnull
  private SimulatorInfo simulator;

  @SerializedName("unavailable_reason")
  private String unavailableReason;

  public String getBenchmarkId() {
    return benchmarkId;
  }

  public Benchmark benchmarkId(String benchmarkId) {
    this.benchmarkId = benchmarkId;
    return this;
  }

  public void setBenchmarkId(String benchmarkId) {
    this.benchmarkId = benchmarkId;
  }

  public String getVersion() {
    return version;
  }

  public Benchmark version(String version) {
    this.version = version;
    return this;
  }

  public void setVersion(String version) {
    this.version = version;
  }

  public String getTitle() {
    return title;
  }

  public Benchmark title(String title) {
    this.title = title;
    return this;
  }

  public void setTitle(String title) {
    this.title = title;
  }

  public String getDescription() {
    return description;
  }

  public Benchmark description(String description) {
    this.description = description;
    return this;
  }

  public void setDescription(String description) {
    this.description = description;
  }

  /** The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software. */
  public String getManifestSha256() {
    return manifestSha256;
  }

  public Benchmark manifestSha256(String manifestSha256) {
    this.manifestSha256 = manifestSha256;
    return this;
  }

  public void setManifestSha256(String manifestSha256) {
    this.manifestSha256 = manifestSha256;
  }

  public Integer getEpisodesTotal() {
    return episodesTotal;
  }

  public Benchmark episodesTotal(Integer episodesTotal) {
    this.episodesTotal = episodesTotal;
    return this;
  }

  public void setEpisodesTotal(Integer episodesTotal) {
    this.episodesTotal = episodesTotal;
  }

  public List<String> getTasks() {
    return tasks;
  }

  public Benchmark tasks(List<String> tasks) {
    this.tasks = tasks;
    return this;
  }

  public void setTasks(List<String> tasks) {
    this.tasks = tasks;
  }

  public List<String> getSplits() {
    return splits;
  }

  public Benchmark splits(List<String> splits) {
    this.splits = splits;
    return this;
  }

  public void setSplits(List<String> splits) {
    this.splits = splits;
  }

  /** Splits whose seeds the host draws in secret; none when absent. */
  public Set<String> getSealedSplits() {
    return sealedSplits;
  }

  public Benchmark sealedSplits(Set<String> sealedSplits) {
    this.sealedSplits = sealedSplits;
    return this;
  }

  public void setSealedSplits(Set<String> sealedSplits) {
    this.sealedSplits = sealedSplits;
  }

  /** What the host commits itself to without showing it, the SHA-256 of a secret salt and the sealed seeds. With both disclosed later, anyone can prove which seeds were played. */
  public String getSeedsSha256() {
    return seedsSha256;
  }

  public Benchmark seedsSha256(String seedsSha256) {
    this.seedsSha256 = seedsSha256;
    return this;
  }

  public void setSeedsSha256(String seedsSha256) {
    this.seedsSha256 = seedsSha256;
  }

  /** Actions per simulated second. */
  public Double getControlRateHz() {
    return controlRateHz;
  }

  public Benchmark controlRateHz(Double controlRateHz) {
    this.controlRateHz = controlRateHz;
    return this;
  }

  public void setControlRateHz(Double controlRateHz) {
    this.controlRateHz = controlRateHz;
  }

  /** Steps after which an episode is truncated. */
  public Integer getMaxSteps() {
    return maxSteps;
  }

  public Benchmark maxSteps(Integer maxSteps) {
    this.maxSteps = maxSteps;
    return this;
  }

  public void setMaxSteps(Integer maxSteps) {
    this.maxSteps = maxSteps;
  }

  public Integer getMaxChunk() {
    return maxChunk;
  }

  public Benchmark maxChunk(Integer maxChunk) {
    this.maxChunk = maxChunk;
    return this;
  }

  public void setMaxChunk(Integer maxChunk) {
    this.maxChunk = maxChunk;
  }

  public Integer getMaxAttempts() {
    return maxAttempts;
  }

  public Benchmark maxAttempts(Integer maxAttempts) {
    this.maxAttempts = maxAttempts;
    return this;
  }

  public void setMaxAttempts(Integer maxAttempts) {
    this.maxAttempts = maxAttempts;
  }

  public Integer getMaxFaults() {
    return maxFaults;
  }

  public Benchmark maxFaults(Integer maxFaults) {
    this.maxFaults = maxFaults;
    return this;
  }

  public void setMaxFaults(Integer maxFaults) {
    this.maxFaults = maxFaults;
  }

  /** A &#x60;SuccessRule&#x60;, or one of a later version. */
  public String getSuccessRule() {
    return successRule;
  }

  public Benchmark successRule(String successRule) {
    this.successRule = successRule;
    return this;
  }

  public void setSuccessRule(String successRule) {
    this.successRule = successRule;
  }

  /** Name of an action value → what it means. */
  public Map<String, VectorSpace> getActionSpace() {
    return actionSpace;
  }

  public Benchmark actionSpace(Map<String, VectorSpace> actionSpace) {
    this.actionSpace = actionSpace;
    return this;
  }

  public void setActionSpace(Map<String, VectorSpace> actionSpace) {
    this.actionSpace = actionSpace;
  }

  public ObservationSpace getObservationSpace() {
    return observationSpace;
  }

  public Benchmark observationSpace(ObservationSpace observationSpace) {
    this.observationSpace = observationSpace;
    return this;
  }

  public void setObservationSpace(ObservationSpace observationSpace) {
    this.observationSpace = observationSpace;
  }

  /** Sizes that may be chosen at submit; the first is the default. */
  public List<ImageSize> getImageSizes() {
    return imageSizes;
  }

  public Benchmark imageSizes(List<ImageSize> imageSizes) {
    this.imageSizes = imageSizes;
    return this;
  }

  public void setImageSizes(List<ImageSize> imageSizes) {
    this.imageSizes = imageSizes;
  }

  /** Codecs that may be chosen at submit; the first is the default. */
  public List<String> getImageCodecs() {
    return imageCodecs;
  }

  public Benchmark imageCodecs(List<String> imageCodecs) {
    this.imageCodecs = imageCodecs;
    return this;
  }

  public void setImageCodecs(List<String> imageCodecs) {
    this.imageCodecs = imageCodecs;
  }

  public SimulatorInfo getSimulator() {
    return simulator;
  }

  public Benchmark simulator(SimulatorInfo simulator) {
    this.simulator = simulator;
    return this;
  }

  public void setSimulator(SimulatorInfo simulator) {
    this.simulator = simulator;
  }

  /** Why a run cannot be submitted here now, and the cure; null when it can. */
  public String getUnavailableReason() {
    return unavailableReason;
  }

  public Benchmark unavailableReason(String unavailableReason) {
    this.unavailableReason = unavailableReason;
    return this;
  }

  public void setUnavailableReason(String unavailableReason) {
    this.unavailableReason = unavailableReason;
  }

  public static Benchmark fromJson(String text) {
    return JSON.getGson().fromJson(text, Benchmark.class);
  }

  public String toJson() {
    return JSON.getGson().toJson(this);
  }

  @Override
  public String toString() {
    return toJson();
  }
}
