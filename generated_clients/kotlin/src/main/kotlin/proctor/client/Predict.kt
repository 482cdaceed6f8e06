/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class Predict(
    @SerialName("session_id") val sessionId: String,
    @SerialName("seq") val seq: Long,
    @SerialName("actions") val actions: List<Action>,
    @SerialName("observe") val observe: Observe? = null,
)
