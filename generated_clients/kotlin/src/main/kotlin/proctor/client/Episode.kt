/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class Episode(
    @SerialName("episode_id") val episodeId: String,
    @SerialName("index") val index: Int,
    @SerialName("task") val task: String,
    @SerialName("split") val split: String,
    @SerialName("status") val status: EpisodeStatus,
    /** The current or next attempt. */
    @SerialName("attempt") val attempt: Int,
    @SerialName("faults") val faults: Int,
    /** In a run with mode `push`: what the policy did wrong when it last ended an attempt of this episode. */
    @SerialName("policy_fault") val policyFault: String? = null,
    @SerialName("result") val result: EpisodeResult? = null,
)
