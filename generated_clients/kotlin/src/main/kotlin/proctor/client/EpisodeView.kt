/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** The episode that the observation belongs to. */
@Serializable
data class EpisodeView(
    @SerialName("episode_id") val episodeId: String,
    /** Position in the manifest. */
    @SerialName("index") val index: Int,
    @SerialName("task") val task: String,
    @SerialName("instruction") val instruction: String,
    @SerialName("attempt") val attempt: Int,
    @SerialName("step") val step: Int,
    @SerialName("max_steps") val maxSteps: Int,
)
