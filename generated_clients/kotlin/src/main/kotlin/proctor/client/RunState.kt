/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
enum class RunState {
    @SerialName("queued") QUEUED,
    @SerialName("ready") READY,
    @SerialName("running") RUNNING,
    @SerialName("stopping") STOPPING,
    @SerialName("stopped") STOPPED,
    @SerialName("failed") FAILED,
    @SerialName("completed") COMPLETED,
}
