/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** The answer to attach (seq 0) and to predict. */
@Serializable
data class Turn(
    @SerialName("session_id") val sessionId: String,
    @SerialName("seq") val seq: Long,
    @SerialName("executed_steps") val executedSteps: Int,
    /** The episode ended before the chunk did. */
    @SerialName("stopped_early") val stoppedEarly: Boolean,
    /** One per executed action. */
    @SerialName("rewards") val rewards: List<Double>,
    /** The task ended by itself in this turn. */
    @SerialName("terminated") val terminated: Boolean,
    /** The step limit ended the episode in this turn. */
    @SerialName("truncated") val truncated: Boolean,
    /** No episode is left for this session. It holds no slot any more; its last turn can be repeated until its lease ends. */
    @SerialName("done") val done: Boolean,
    @SerialName("lease") val lease: Lease,
    @SerialName("timing") val timing: Timing,
    @SerialName("episode") val episode: EpisodeView? = null,
    @SerialName("observation") val observation: Observation? = null,
    /** With `observe` all, one per executed action. */
    @SerialName("observations") val observations: List<Observation>? = null,
    @SerialName("episode_result") val episodeResult: EpisodeResult? = null,
    @SerialName("fault") val fault: Fault? = null,
)
