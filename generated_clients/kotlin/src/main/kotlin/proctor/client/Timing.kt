/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** Server time of this turn, in seconds. */
@Serializable
data class Timing(
    @SerialName("total_s") val totalS: Double,
    @SerialName("queue_s") val queueS: Double,
    @SerialName("simulate_s") val simulateS: Double,
    @SerialName("render_s") val renderS: Double,
    /** Encoding of images. */
    @SerialName("encode_s") val encodeS: Double,
)
