/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** The policy is ready for this attempt and no other. */
@Serializable
data class PolicyReset(
    @SerialName("session_id") val sessionId: String,
    @SerialName("episode_id") val episodeId: String,
    @SerialName("attempt") val attempt: Int,
)
