/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** RFC 9457, with what a client needs to decide on a retry. */
@Serializable
data class Problem(
    @SerialName("type") val type: String,
    @SerialName("title") val title: String,
    @SerialName("status") val status: Int,
    /** What happened and what to do about it. */
    @SerialName("detail") val detail: String,
    /** One of x-problems, or one of a later version. */
    @SerialName("code") val code: String,
    /** Whether the same request can succeed later. */
    @SerialName("retryable") val retryable: Boolean,
    @SerialName("side_effects") val sideEffects: SideEffects,
    @SerialName("errors") val errors: List<ProblemItem>? = null,
    /** Id of the rule that was enforced. */
    @SerialName("requirement") val requirement: String? = null,
    @SerialName("state") val state: RunState? = null,
    @SerialName("expected_seq") val expectedSeq: Long? = null,
    /** What ended the session, as far as the server still knows; `unknown` after a restart, and for a session that was taken over and whose successor has ended. */
    @SerialName("ended_by") val endedBy: String? = null,
)
