/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** What a policy server says of itself; see policy.yaml. */
@Serializable
data class PolicyDescription(
    @SerialName("name") val name: String,
    @SerialName("protocol") val protocol: ProtocolRange,
    /** Most episodes that it plays at a time. */
    @SerialName("max_sessions") val maxSessions: Int,
    @SerialName("version") val version: String? = null,
    @SerialName("assumes") val assumes: Assumptions? = null,
)
