/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class SimulatorInfo(
    @SerialName("name") val name: String,
    @SerialName("version") val version: String,
    /** Named rendering quality, where there is one. */
    @SerialName("quality") val quality: String? = null,
)
