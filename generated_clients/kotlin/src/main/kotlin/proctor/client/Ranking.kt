/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** See board.md for every number here. */
@Serializable
data class Ranking(
    @SerialName("benchmark_id") val benchmarkId: String,
    /** The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software. */
    @SerialName("manifest_sha256") val manifestSha256: String,
    /** How many episodes each entry has; null where the manifest has no entry. */
    @SerialName("episodes_total") val episodesTotal: Int?,
    /** How many entries have a rank. */
    @SerialName("ranked") val ranked: Int,
    /** How many pairs of them were tested. */
    @SerialName("comparisons") val comparisons: Long,
    /** How likely it is at most that any two equally good policies are distinguished; 0.05. */
    @SerialName("alpha") val alpha: Double,
    /** Two entries that differ on fewer episodes can never be distinguished; null if the benchmark has fewer episodes. */
    @SerialName("differing_min") val differingMin: Int?,
    /** Two entries that differ on so many episodes, all to the advantage of one, are distinguished, however the others fared; null if the benchmark has fewer episodes. */
    @SerialName("differing_enough") val differingEnough: Int?,
    @SerialName("rows") val rows: List<RankedEntry>,
    @SerialName("next_cursor") val nextCursor: String?,
)
