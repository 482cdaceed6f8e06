/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class FlagEntry(
    /** False takes the flag back. */
    @SerialName("flagged") val flagged: Boolean,
    /** Shown with the entry. */
    @SerialName("reason") val reason: String,
)
