/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** The policy server of a run with mode `push`, with what was left open filled in, and without its key. */
@Serializable
data class PolicyServerView(
    @SerialName("url") val url: String,
    /** A `PolicyProtocol`, or one of a later version. */
    @SerialName("protocol") val protocol: String,
    @SerialName("has_api_key") val hasApiKey: Boolean,
    @SerialName("call_timeout_s") val callTimeoutS: Double,
    @SerialName("max_concurrent") val maxConcurrent: Int,
    @SerialName("max_retries") val maxRetries: Int,
    @SerialName("model") val model: String? = null,
    @SerialName("generation") val generation: Map<String, Double>? = null,
)
