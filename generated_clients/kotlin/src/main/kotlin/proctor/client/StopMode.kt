/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** `abort` when absent. */
@Serializable
enum class StopMode {
    @SerialName("abort") ABORT,
    @SerialName("drain") DRAIN,
}
