/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** The first state that was another one; absent where every state was met. */
@Serializable
data class ReplayDivergence(
    @SerialName("episode_index") val episodeIndex: Int,
    @SerialName("attempt") val attempt: Long,
    /** After how many steps of the attempt the state was another one. */
    @SerialName("step") val step: Long,
)
