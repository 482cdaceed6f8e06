/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class AttachWorker(
    /** New for every attachment; repeated only to repeat a lost request. */
    @SerialName("attach_key") val attachKey: String,
    /** Fence out a live session; false when absent. */
    @SerialName("takeover") val takeover: Boolean? = null,
    @SerialName("assumes") val assumes: Assumptions? = null,
    @SerialName("player") val player: Player? = null,
)
