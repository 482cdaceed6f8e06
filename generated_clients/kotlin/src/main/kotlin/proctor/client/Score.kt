/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** See scoring.md for every number here. */
@Serializable
data class Score(
    @SerialName("run_id") val runId: String,
    @SerialName("benchmark_id") val benchmarkId: String,
    /** The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software. */
    @SerialName("manifest_sha256") val manifestSha256: String,
    @SerialName("state") val state: RunState,
    @SerialName("complete") val complete: Boolean,
    /** Null until complete. */
    @SerialName("score") val score: Double?,
    @SerialName("score_low") val scoreLow: Double,
    @SerialName("score_high") val scoreHigh: Double,
    @SerialName("counts") val counts: OutcomeCounts,
    @SerialName("success_rate") val successRate: Double?,
    @SerialName("success_interval") val successInterval: Interval,
    /** Mean over the scored episodes. */
    @SerialName("mean") val mean: Double?,
    @SerialName("mean_interval") val meanInterval: Interval,
    @SerialName("by_task") val byTask: Map<String, GroupScore>,
    @SerialName("by_split") val bySplit: Map<String, GroupScore>,
    @SerialName("select") val select: SelectionView? = null,
)
