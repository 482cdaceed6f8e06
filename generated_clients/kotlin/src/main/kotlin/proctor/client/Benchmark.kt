/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** Everything about a benchmark that can change a score. */
@Serializable
data class Benchmark(
    @SerialName("benchmark_id") val benchmarkId: String,
    @SerialName("version") val version: String,
    @SerialName("title") val title: String,
    @SerialName("description") val description: String,
    /** The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software. */
    @SerialName("manifest_sha256") val manifestSha256: String,
    @SerialName("episodes_total") val episodesTotal: Int,
    @SerialName("tasks") val tasks: List<String>,
    @SerialName("splits") val splits: List<String>,
    /** Actions per simulated second. */
    @SerialName("control_rate_hz") val controlRateHz: Double,
    /** Steps after which an episode is truncated. */
    @SerialName("max_steps") val maxSteps: Int,
    @SerialName("max_chunk") val maxChunk: Int,
    @SerialName("max_attempts") val maxAttempts: Int,
    @SerialName("max_faults") val maxFaults: Int,
    /** A `SuccessRule`, or one of a later version. */
    @SerialName("success_rule") val successRule: String,
    /** Name of an action value → what it means. */
    @SerialName("action_space") val actionSpace: Map<String, VectorSpace>,
    @SerialName("observation_space") val observationSpace: ObservationSpace,
    /** Sizes that may be chosen at submit; the first is the default. */
    @SerialName("image_sizes") val imageSizes: List<ImageSize>,
    /** Codecs that may be chosen at submit; the first is the default. */
    @SerialName("image_codecs") val imageCodecs: List<String>,
    @SerialName("simulator") val simulator: SimulatorInfo,
    /** Why a run cannot be submitted here now, and the cure; null when it can. */
    @SerialName("unavailable_reason") val unavailableReason: String?,
    /** Splits whose seeds the host draws in secret; none when absent. */
    @SerialName("sealed_splits") val sealedSplits: Set<String>? = null,
    /** What the host commits itself to without showing it, the SHA-256 of a secret salt and the sealed seeds. With both disclosed later, anyone can prove which seeds were played. */
    @SerialName("seeds_sha256") val seedsSha256: String? = null,
)
