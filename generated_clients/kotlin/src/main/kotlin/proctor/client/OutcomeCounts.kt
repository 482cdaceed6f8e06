/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class OutcomeCounts(
    @SerialName("total") val total: Int,
    @SerialName("success") val success: Int,
    @SerialName("failure") val failure: Int,
    @SerialName("abandoned") val abandoned: Int,
    @SerialName("unscored") val unscored: Int,
)
