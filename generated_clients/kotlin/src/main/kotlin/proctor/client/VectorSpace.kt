/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** One named vector of numbers, with every convention a policy could get wrong. */
@Serializable
data class VectorSpace(
    @SerialName("size") val size: Int,
    /** `rad`, `m`, `1`, or several joined by commas. */
    @SerialName("unit") val unit: String,
    @SerialName("rotation") val rotation: String,
    /** `world`, `base`, `tool`, `joint`, or `none`. */
    @SerialName("frame") val frame: String,
    /** True when the values are increments. */
    @SerialName("relative") val relative: Boolean,
    @SerialName("out_of_range") val outOfRange: String,
    /** The value that means fully open. */
    @SerialName("gripper_open") val gripperOpen: Double? = null,
    @SerialName("minimum") val minimum: List<Double>? = null,
    @SerialName("maximum") val maximum: List<Double>? = null,
    /** What the numbers are. */
    @SerialName("description") val description: String? = null,
    /** The tasks that have this entry; all of them when absent. */
    @SerialName("tasks") val tasks: List<String>? = null,
)
