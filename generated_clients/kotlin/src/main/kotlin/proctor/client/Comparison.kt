/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** See scoring.md for every number here. */
@Serializable
data class Comparison(
    /** Id of the run that the others are compared with. */
    @SerialName("baseline") val baseline: String,
    @SerialName("benchmark_id") val benchmarkId: String,
    /** The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software. */
    @SerialName("manifest_sha256") val manifestSha256: String,
    @SerialName("tolerance") val tolerance: Double,
    /** One entry per run that was named, in that order. */
    @SerialName("runs") val runs: List<ComparedRun>,
)
