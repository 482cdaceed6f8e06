/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class EpisodeResult(
    @SerialName("episode_id") val episodeId: String,
    @SerialName("index") val index: Int,
    @SerialName("task") val task: String,
    @SerialName("split") val split: String,
    @SerialName("attempt") val attempt: Int,
    @SerialName("faults") val faults: Int,
    @SerialName("outcome") val outcome: Outcome,
    @SerialName("score") val score: Double,
    @SerialName("steps") val steps: Int,
    @SerialName("terminated") val terminated: Boolean,
    @SerialName("truncated") val truncated: Boolean,
    /** Time between turns that the policy took. */
    @SerialName("think_s") val thinkS: Double,
    @SerialName("finished_at") val finishedAt: String,
    /** Absent where `sealed_splits` of the benchmark names the split. */
    @SerialName("seed") val seed: Long? = null,
    @SerialName("player") val player: PlayerView? = null,
    /** Actions of the attempt with a number outside of a range that is declared `clip`; for the profile `attribution`. */
    @SerialName("clipped_actions") val clippedActions: Int? = null,
    /** Sum of the rewards of the attempt, its return; for the profile `attribution`. */
    @SerialName("total_reward") val totalReward: Double? = null,
)
