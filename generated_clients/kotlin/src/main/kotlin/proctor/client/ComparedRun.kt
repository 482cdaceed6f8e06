/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** One run beside the baseline. A pair is an episode that both have scored. */
@Serializable
data class ComparedRun(
    @SerialName("run_id") val runId: String,
    /** Both runs have scored every episode. */
    @SerialName("complete") val complete: Boolean,
    /** Complete, and no difference, over all episodes or over those of a task, is beyond the tolerance. */
    @SerialName("release") val release: Boolean,
    /** Number of pairs. */
    @SerialName("paired") val paired: Int,
    /** Mean score of the baseline over the pairs. */
    @SerialName("baseline_mean") val baselineMean: Double?,
    /** Mean score of the run over the pairs. */
    @SerialName("mean") val mean: Double?,
    /** Baseline minus run: positive when the run is worse. */
    @SerialName("difference") val difference: Double?,
    /** Pairs in which the run alone succeeds. */
    @SerialName("wins") val wins: Int,
    /** Pairs in which the baseline alone succeeds. */
    @SerialName("losses") val losses: Int,
    /** Pairs in which both succeed or neither does. */
    @SerialName("ties") val ties: Int,
    /** McNemar's exact test, two-sided. */
    @SerialName("p_value") val pValue: Double,
    /** Task → the pairs of its episodes. */
    @SerialName("by_task") val byTask: Map<String, ComparedTask>,
)
