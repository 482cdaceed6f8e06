/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class Limits(
    /** Longest request body that is read. */
    @SerialName("max_body_bytes") val maxBodyBytes: Long,
    /** Most live workers a run may ask for. */
    @SerialName("max_workers") val maxWorkers: Int,
    /** Most actions in one predict; a benchmark may allow fewer. */
    @SerialName("max_chunk") val maxChunk: Int,
    @SerialName("idle_timeout_s_min") val idleTimeoutSMin: Double,
    @SerialName("idle_timeout_s_max") val idleTimeoutSMax: Double,
    /** Longest wait that a long-poll is granted. */
    @SerialName("wait_s_max") val waitSMax: Int,
    /** Longest request line with its headers that is read; for the profile `limits`. */
    @SerialName("max_header_bytes") val maxHeaderBytes: Int? = null,
    /** Time in which the headers of a request are complete, from its first byte; for the profile `limits`. */
    @SerialName("header_timeout_s") val headerTimeoutS: Double? = null,
    /** Time in which a part of a body arrives after the headers of its request; for the profile `limits`. */
    @SerialName("body_timeout_s") val bodyTimeoutS: Double? = null,
    /** Longest time that a session lives without a new turn, whatever its `idle_timeout_s`; for the profile `limits`. */
    @SerialName("heartbeat_s_max") val heartbeatSMax: Double? = null,
    /** When others wait: the time after which a run without a worker, or a session without a turn, may make room; for the profile `limits`. */
    @SerialName("unused_s_max") val unusedSMax: Double? = null,
    /** Longest body that is read of a request other than `predict`, where it is less than `max_body_bytes`; for the profile `limits`. */
    @SerialName("max_control_body_bytes") val maxControlBodyBytes: Long? = null,
    /** Most runs of one account that are queued, ready, running or stopping; for the profile `limits`. */
    @SerialName("max_open_runs") val maxOpenRuns: Int? = null,
    /** Most Idempotency-Keys that one account may use; for the profile `limits`. */
    @SerialName("max_idempotency_keys") val maxIdempotencyKeys: Long? = null,
    /** Most bytes that the submissions of one account may have together; what else a server stores for a run may count, too. For the profile `limits`. */
    @SerialName("max_stored_bytes") val maxStoredBytes: Long? = null,
    /** Longest archive that `import_record` reads; for the profile `record_import`. */
    @SerialName("max_record_bytes") val maxRecordBytes: Long? = null,
    /** Most imports of one account that are not `finished`; for the profile `record_import`. */
    @SerialName("max_waiting_imports") val maxWaitingImports: Int? = null,
    /** Most bytes that the archives of one account may have together; for the profile `record_import`. */
    @SerialName("max_imported_bytes") val maxImportedBytes: Long? = null,
    /** Days without a change after which a run that has completed, failed or been stopped may be deleted; when absent, none is. For the profile `deletion`. */
    @SerialName("run_keep_days") val runKeepDays: Double? = null,
)
