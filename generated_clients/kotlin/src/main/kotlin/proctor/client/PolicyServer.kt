/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** Where the server finds the policy of a run with mode `push`, and how it calls it. */
@Serializable
data class PolicyServer(
    /** Base URL, without user, query or fragment; the path of an operation is appended to it. */
    @SerialName("url") val url: String,
    @SerialName("protocol") val protocol: PolicyProtocol,
    /** Sent as bearer token with every call, and never shown. */
    @SerialName("api_key") val apiKey: String? = null,
    /** Which model is asked, where a protocol knows several. */
    @SerialName("model") val model: String? = null,
    /** Time for one call, from connecting to the last byte of its answer; 30 when absent. */
    @SerialName("call_timeout_s") val callTimeoutS: Double? = null,
    /** Most episodes played and calls made at a time; as many as the policy, the run and the server allow when absent. */
    @SerialName("max_concurrent") val maxConcurrent: Int? = null,
    /** How often a call that was not answered is repeated; 3 when absent. */
    @SerialName("max_retries") val maxRetries: Int? = null,
    /** Numbers that a chat completion is asked with, such as `temperature` and `max_tokens`; for `openai_chat` and `openai_completions` alone. */
    @SerialName("generation") val generation: Map<String, Double>? = null,
)
