/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class ComparedTask(
    @SerialName("paired") val paired: Int,
    @SerialName("baseline_mean") val baselineMean: Double?,
    @SerialName("mean") val mean: Double?,
    @SerialName("difference") val difference: Double?,
)
