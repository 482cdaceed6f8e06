/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** `pull` when absent: workers attach and predict. `push`: the server calls the policy itself, and workers of the run are its own. */
@Serializable
enum class RunMode {
    @SerialName("pull") PULL,
    @SerialName("push") PUSH,
}
