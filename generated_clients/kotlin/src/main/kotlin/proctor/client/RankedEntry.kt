/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class RankedEntry(
    @SerialName("entry") val entry: BoardEntry,
    /** How many entries are significantly better; 0 without a rank. */
    @SerialName("better") val better: Int,
    /** How many entries are significantly worse; 0 without a rank. */
    @SerialName("worse") val worse: Int,
    /** Entries that cannot be distinguished have a letter in common, others have none in common; empty without a rank. */
    @SerialName("letters") val letters: List<String>,
    @SerialName("rank") val rank: RankInterval? = null,
)
