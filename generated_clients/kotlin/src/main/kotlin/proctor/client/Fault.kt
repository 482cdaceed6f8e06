/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** The simulator broke; the episode began again, at no cost to the policy. Nothing of the chunk counts as executed. A turn that ends an episode has its result instead, and `list_episodes` the faults of the next one. */
@Serializable
data class Fault(
    @SerialName("episode_id") val episodeId: String,
    /** Faults of this episode so far. */
    @SerialName("faults") val faults: Int,
    @SerialName("detail") val detail: String,
)
