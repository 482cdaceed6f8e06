/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** A record that was handed in, and what is known of it here. */
@Serializable
data class RecordImport(
    @SerialName("import_id") val importId: String,
    /** `waiting` for simulators, `replaying`, or `finished`. */
    @SerialName("state") val state: String,
    /** `reported`: whole, by anyone; `signed` by a key that this server knows; `replayed` here with the same results; `diverged`: the replay came out otherwise. */
    @SerialName("level") val level: String,
    /** The level with who says it, as REC-031 has it. */
    @SerialName("level_text") val levelText: String,
    /** Whose key signed the record, as this server knows it; null for a key that it does not know. */
    @SerialName("signer") val signer: String?,
    /** Of the key that signed the record. */
    @SerialName("keyid") val keyid: String,
    @SerialName("archive_sha256") val archiveSha256: String,
    @SerialName("statement_sha256") val statementSha256: String,
    @SerialName("size_bytes") val sizeBytes: Long,
    /** In the statement, as are the members below it. */
    @SerialName("run_id") val runId: String,
    @SerialName("benchmark_id") val benchmarkId: String,
    @SerialName("benchmark_version") val benchmarkVersion: String,
    @SerialName("manifest_sha256") val manifestSha256: String,
    @SerialName("policy") val policy: ImportedPolicy,
    /** Null where an episode has no result. */
    @SerialName("score") val score: Double?,
    @SerialName("episodes") val episodes: Int,
    /** How many of them were simulated so far. */
    @SerialName("episodes_replayed") val episodesReplayed: Int,
    /** Why there is no replay. */
    @SerialName("reason") val reason: String?,
    @SerialName("imported_at") val importedAt: String,
    @SerialName("finished_at") val finishedAt: String?,
    @SerialName("replay") val replay: RecordReplay? = null,
)
