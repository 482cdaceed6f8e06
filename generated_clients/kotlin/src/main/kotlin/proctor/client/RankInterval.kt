/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** The ranks that an entry may have; absent for an entry that is flagged. */
@Serializable
data class RankInterval(
    /** The best one. */
    @SerialName("low") val low: Int,
    /** The worst one. */
    @SerialName("high") val high: Int,
)
