/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class Progress(
    @SerialName("episodes_total") val episodesTotal: Int,
    /** Abandoned ones included. */
    @SerialName("episodes_scored") val episodesScored: Int,
    @SerialName("episodes_in_progress") val episodesInProgress: Int,
    @SerialName("episodes_pending") val episodesPending: Int,
)
