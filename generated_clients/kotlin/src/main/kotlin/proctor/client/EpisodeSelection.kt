/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** The part of a benchmark that is played, all of it where a member is absent; for the profile `subsets`. */
@Serializable
data class EpisodeSelection(
    @SerialName("tasks") val tasks: List<String>? = null,
    @SerialName("splits") val splits: List<String>? = null,
)
