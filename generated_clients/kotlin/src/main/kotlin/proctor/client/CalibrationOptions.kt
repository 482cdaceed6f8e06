/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** Only for the benchmark `calibration`, which the submitter shapes. */
@Serializable
data class CalibrationOptions(
    /** One entry per episode, in order; one `score` episode when absent. */
    @SerialName("tasks") val tasks: List<CalibrationTask>? = null,
    /** 10 when absent. */
    @SerialName("max_steps") val maxSteps: Int? = null,
    @SerialName("success_rule") val successRule: SuccessRule? = null,
    /** 3 when absent. */
    @SerialName("max_attempts") val maxAttempts: Int? = null,
    /** 3 when absent. */
    @SerialName("max_faults") val maxFaults: Int? = null,
    /** Whether the seeds of the split `odd` are sealed; false when absent. Only for servers that announce the profile `sealed_seeds`. */
    @SerialName("sealed") val `sealed`: Boolean? = null,
    /** Seconds for which the run stays queued after submit and after resume; 0 when absent. */
    @SerialName("queue_s") val queueS: Double? = null,
)
