/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** 95 % interval. */
@Serializable
data class Interval(
    @SerialName("low") val low: Double,
    @SerialName("high") val high: Double,
)
