/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class BenchmarkSummary(
    @SerialName("benchmark_id") val benchmarkId: String,
    @SerialName("version") val version: String,
    @SerialName("title") val title: String,
    /** The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software. */
    @SerialName("manifest_sha256") val manifestSha256: String,
    @SerialName("episodes_total") val episodesTotal: Int,
)
