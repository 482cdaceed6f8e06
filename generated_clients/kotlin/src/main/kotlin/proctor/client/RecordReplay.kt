/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** As in a verdict (record.md); absent before the end of the replay, and where there is none. */
@Serializable
data class RecordReplay(
    /** `exact`, `outcome` or `diverged`. */
    @SerialName("result") val result: String,
    @SerialName("episodes") val episodes: Int,
    @SerialName("exact") val exact: Int,
    @SerialName("outcome") val outcome: Int,
    @SerialName("diverged") val diverged: Int,
    @SerialName("first_divergence") val firstDivergence: ReplayDivergence? = null,
)
