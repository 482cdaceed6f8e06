/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class GroupScore(
    @SerialName("counts") val counts: OutcomeCounts,
    @SerialName("mean") val mean: Double?,
    @SerialName("success_rate") val successRate: Double?,
)
