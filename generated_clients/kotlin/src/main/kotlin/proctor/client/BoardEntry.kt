/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class BoardEntry(
    @SerialName("entry_id") val entryId: String,
    @SerialName("run_id") val runId: String,
    /** Name of the account that submitted the run. */
    @SerialName("submitter") val submitter: String,
    @SerialName("benchmark_id") val benchmarkId: String,
    @SerialName("benchmark_version") val benchmarkVersion: String,
    /** The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software. */
    @SerialName("manifest_sha256") val manifestSha256: String,
    @SerialName("policy") val policy: PolicyInfo,
    @SerialName("model_name") val modelName: String,
    @SerialName("is_public") val isPublic: Boolean,
    @SerialName("state") val state: String,
    /** What is known of the score: `reported` by the server alone; `signed`, for the run has a record that this host signs. */
    @SerialName("level") val level: String,
    /** How many runs of the benchmark the account has submitted until now, published or not. */
    @SerialName("attempts") val attempts: Int,
    @SerialName("score") val score: EntryScore,
    @SerialName("published_at") val publishedAt: String,
    /** When the description, the state or the flag changed for the last time. */
    @SerialName("changed_at") val changedAt: String,
    @SerialName("select") val select: SelectionView? = null,
    @SerialName("model_type") val modelType: String? = null,
    @SerialName("organisation") val organisation: String? = null,
    @SerialName("homepage") val homepage: String? = null,
    @SerialName("code_url") val codeUrl: String? = null,
    @SerialName("notes") val notes: String? = null,
    @SerialName("flag") val flag: EntryFlag? = null,
)
