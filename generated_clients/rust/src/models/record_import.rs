/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// RecordImport : A record that was handed in, and what is known of it here.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct RecordImport {
    #[serde(rename = "import_id")]
    pub import_id: String,
    /// `waiting` for simulators, `replaying`, or `finished`.
    #[serde(rename = "state")]
    pub state: String,
    /// `reported`: whole, by anyone; `signed` by a key that this server knows; `replayed` here with the same results; `diverged`: the replay came out otherwise.
    #[serde(rename = "level")]
    pub level: String,
    /// The level with who says it, as REC-031 has it.
    #[serde(rename = "level_text")]
    pub level_text: String,
    /// Whose key signed the record, as this server knows it; null for a key that it does not know.
    #[serde(rename = "signer", deserialize_with = "Option::deserialize")]
    pub signer: Option<String>,
    /// Of the key that signed the record.
    #[serde(rename = "keyid")]
    pub keyid: String,
    #[serde(rename = "archive_sha256")]
    pub archive_sha256: String,
    #[serde(rename = "statement_sha256")]
    pub statement_sha256: String,
    #[serde(rename = "size_bytes")]
    pub size_bytes: i64,
    /// In the statement, as are the members below it.
    #[serde(rename = "run_id")]
    pub run_id: String,
    #[serde(rename = "benchmark_id")]
    pub benchmark_id: String,
    #[serde(rename = "benchmark_version")]
    pub benchmark_version: String,
    #[serde(rename = "manifest_sha256")]
    pub manifest_sha256: String,
    #[serde(rename = "policy")]
    pub policy: models::ImportedPolicy,
    /// Null where an episode has no result.
    #[serde(rename = "score", deserialize_with = "Option::deserialize")]
    pub score: Option<f64>,
    #[serde(rename = "episodes")]
    pub episodes: i32,
    /// How many of them were simulated so far.
    #[serde(rename = "episodes_replayed")]
    pub episodes_replayed: i32,
    #[serde(rename = "replay", skip_serializing_if = "Option::is_none")]
    pub replay: Option<models::RecordReplay>,
    /// Why there is no replay.
    #[serde(rename = "reason", deserialize_with = "Option::deserialize")]
    pub reason: Option<String>,
    #[serde(rename = "imported_at")]
    pub imported_at: chrono::DateTime<chrono::FixedOffset>,
    #[serde(rename = "finished_at", deserialize_with = "Option::deserialize")]
    pub finished_at: Option<chrono::DateTime<chrono::FixedOffset>>,
}

impl RecordImport {
    /// A record that was handed in, and what is known of it here.
    pub fn new(import_id: String, state: String, level: String, level_text: String, signer: Option<String>, keyid: String, archive_sha256: String, statement_sha256: String, size_bytes: i64, run_id: String, benchmark_id: String, benchmark_version: String, manifest_sha256: String, policy: models::ImportedPolicy, score: Option<f64>, episodes: i32, episodes_replayed: i32, reason: Option<String>, imported_at: chrono::DateTime<chrono::FixedOffset>, finished_at: Option<chrono::DateTime<chrono::FixedOffset>>) -> RecordImport {
        RecordImport {
            import_id,
            state,
            level,
            level_text,
            signer,
            keyid,
            archive_sha256,
            statement_sha256,
            size_bytes,
            run_id,
            benchmark_id,
            benchmark_version,
            manifest_sha256,
            policy,
            score,
            episodes,
            episodes_replayed,
            replay: None,
            reason,
            imported_at,
            finished_at,
        }
    }
}
