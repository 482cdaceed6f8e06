/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** An attempt begins; whatever the policy remembers of this session is over. */
@Serializable
data class ResetPolicy(
    @SerialName("session_id") val sessionId: String,
    @SerialName("benchmark") val benchmark: Benchmark,
    @SerialName("episode") val episode: EpisodeView,
    @SerialName("run_id") val runId: String? = null,
)
