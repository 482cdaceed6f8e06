/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** What the policy takes for granted; refused when the benchmark says otherwise (ATT-010). */
@Serializable
data class Assumptions(
    @SerialName("control_rate_hz") val controlRateHz: Double? = null,
    @SerialName("action") val action: Map<String, Assumption>? = null,
    @SerialName("state") val state: Map<String, Assumption>? = null,
)
