/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
enum class CalibrationTask {
    @SerialName("score") SCORE,
    @SerialName("count") COUNT,
    @SerialName("echo") ECHO,
    @SerialName("delay") DELAY,
    @SerialName("fault") FAULT,
}
