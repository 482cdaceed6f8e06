/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** Of the `get_score` of the run. */
@Serializable
data class EntryScore(
    @SerialName("score") val score: Double,
    @SerialName("success_rate") val successRate: Double,
    @SerialName("success_interval") val successInterval: Interval,
    @SerialName("mean_interval") val meanInterval: Interval,
    @SerialName("counts") val counts: OutcomeCounts,
    /** Absent where the server does not show it, such as for many tasks. */
    @SerialName("by_task") val byTask: Map<String, GroupScore>? = null,
    /** Absent where the server does not show it, such as for many splits. */
    @SerialName("by_split") val bySplit: Map<String, GroupScore>? = null,
)
