/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** The `select` of a run, as it was submitted. */
@Serializable
data class SelectionView(
    @SerialName("tasks") val tasks: List<String>? = null,
    @SerialName("splits") val splits: List<String>? = null,
)
