/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class Run(
    @SerialName("run_id") val runId: String,
    @SerialName("state") val state: RunState,
    /** Why the run is in this state, for people; never null when failed. */
    @SerialName("reason") val reason: String?,
    /** Whether a failed run may be resumed; null in other states. */
    @SerialName("retryable") val retryable: Boolean?,
    @SerialName("benchmark_id") val benchmarkId: String,
    @SerialName("benchmark_version") val benchmarkVersion: String,
    /** The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software. */
    @SerialName("manifest_sha256") val manifestSha256: String,
    @SerialName("policy") val policy: PolicyInfo,
    @SerialName("max_workers") val maxWorkers: Int,
    @SerialName("idle_timeout_s") val idleTimeoutS: Double,
    @SerialName("images") val images: ImageChoice,
    /** Base URL of the data plane for this run; the path of an operation is appended to it. */
    @SerialName("endpoint") val endpoint: String,
    /** 1 is next; null unless queued. */
    @SerialName("queue_position") val queuePosition: Int?,
    @SerialName("live_workers") val liveWorkers: Int,
    @SerialName("progress") val progress: Progress,
    @SerialName("created_at") val createdAt: String,
    @SerialName("updated_at") val updatedAt: String,
    /** A `RunMode`, or one of a later version; `pull` when absent. */
    @SerialName("mode") val mode: String? = null,
    @SerialName("policy_server") val policyServer: PolicyServerView? = null,
    /** Whether workers may play for another policy than `policy`; for the profile `attribution`. */
    @SerialName("any_policy") val anyPolicy: Boolean? = null,
    @SerialName("select") val select: SelectionView? = null,
    /** In how many runs of this benchmark its submitter had executed an action before the first one of this run, whether they were deleted or not; absent before that action. For the profile `deletion`. */
    @SerialName("runs_played_before") val runsPlayedBefore: Int? = null,
    /** How many runs of this benchmark its submitter had submitted, this one included; for the profile `record`. */
    @SerialName("attempts_by_submitter") val attemptsBySubmitter: Int? = null,
)
