/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class Assumption(
    @SerialName("size") val size: Int? = null,
    @SerialName("unit") val unit: String? = null,
    @SerialName("rotation") val rotation: String? = null,
    @SerialName("frame") val frame: String? = null,
    @SerialName("relative") val relative: Boolean? = null,
    @SerialName("gripper_open") val gripperOpen: Double? = null,
)
