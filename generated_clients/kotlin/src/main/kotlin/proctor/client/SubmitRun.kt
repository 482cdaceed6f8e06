/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class SubmitRun(
    @SerialName("benchmark_id") val benchmarkId: String,
    @SerialName("policy") val policy: PolicyInfo,
    /** Most live workers wanted; the server's limit when absent. */
    @SerialName("max_workers") val maxWorkers: Int? = null,
    /** Lease of a session; the server's maximum when absent. */
    @SerialName("idle_timeout_s") val idleTimeoutS: Double? = null,
    @SerialName("images") val images: ImageChoice? = null,
    @SerialName("options") val options: CalibrationOptions? = null,
    @SerialName("mode") val mode: RunMode? = null,
    @SerialName("policy_server") val policyServer: PolicyServer? = null,
    /** Workers may play for another policy than `policy`; false when absent; for the profile `attribution`. */
    @SerialName("any_policy") val anyPolicy: Boolean? = null,
    @SerialName("select") val select: EpisodeSelection? = null,
)
