/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct BoardEntry {
    #[serde(rename = "entry_id")]
    pub entry_id: String,
    #[serde(rename = "run_id")]
    pub run_id: String,
    /// Name of the account that submitted the run.
    #[serde(rename = "submitter")]
    pub submitter: String,
    #[serde(rename = "benchmark_id")]
    pub benchmark_id: String,
    #[serde(rename = "benchmark_version")]
    pub benchmark_version: String,
    /// The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
    #[serde(rename = "manifest_sha256")]
    pub manifest_sha256: String,
    #[serde(rename = "select", skip_serializing_if = "Option::is_none")]
    pub select: Option<models::SelectionView>,
    #[serde(rename = "policy")]
    pub policy: Box<models::PolicyInfo>,
    #[serde(rename = "model_name")]
    pub model_name: String,
    #[serde(rename = "is_public")]
    pub is_public: bool,
    #[serde(rename = "model_type", skip_serializing_if = "Option::is_none")]
    pub model_type: Option<String>,
    #[serde(rename = "organisation", skip_serializing_if = "Option::is_none")]
    pub organisation: Option<String>,
    #[serde(rename = "homepage", skip_serializing_if = "Option::is_none")]
    pub homepage: Option<String>,
    #[serde(rename = "code_url", skip_serializing_if = "Option::is_none")]
    pub code_url: Option<String>,
    #[serde(rename = "notes", skip_serializing_if = "Option::is_none")]
    pub notes: Option<String>,
    #[serde(rename = "state")]
    pub state: String,
    #[serde(rename = "flag", skip_serializing_if = "Option::is_none")]
    pub flag: Option<models::EntryFlag>,
    /// What is known of the score: `reported` by the server alone; `signed`, for the run has a record that this host signs.
    #[serde(rename = "level")]
    pub level: String,
    /// How many runs of the benchmark the account has submitted until now, published or not.
    #[serde(rename = "attempts")]
    pub attempts: i32,
    #[serde(rename = "score")]
    pub score: models::EntryScore,
    #[serde(rename = "published_at")]
    pub published_at: chrono::DateTime<chrono::FixedOffset>,
    /// When the description, the state or the flag changed for the last time.
    #[serde(rename = "changed_at")]
    pub changed_at: chrono::DateTime<chrono::FixedOffset>,
}

impl BoardEntry {
    pub fn new(entry_id: String, run_id: String, submitter: String, benchmark_id: String, benchmark_version: String, manifest_sha256: String, policy: models::PolicyInfo, model_name: String, is_public: bool, state: String, level: String, attempts: i32, score: models::EntryScore, published_at: chrono::DateTime<chrono::FixedOffset>, changed_at: chrono::DateTime<chrono::FixedOffset>) -> BoardEntry {
        BoardEntry {
            entry_id,
            run_id,
            submitter,
            benchmark_id,
            benchmark_version,
            manifest_sha256,
            select: None,
            policy: Box::new(policy),
            model_name,
            is_public,
            model_type: None,
            organisation: None,
            homepage: None,
            code_url: None,
            notes: None,
            state,
            flag: None,
            level,
            attempts,
            score,
            published_at,
            changed_at,
        }
    }
}
