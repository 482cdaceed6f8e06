/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct Run {
    #[serde(rename = "run_id")]
    pub run_id: String,
    #[serde(rename = "state")]
    pub state: models::RunState,
    /// Why the run is in this state, for people; never null when failed.
    #[serde(rename = "reason", deserialize_with = "Option::deserialize")]
    pub reason: Option<String>,
    /// Whether a failed run may be resumed; null in other states.
    #[serde(rename = "retryable", deserialize_with = "Option::deserialize")]
    pub retryable: Option<bool>,
    #[serde(rename = "benchmark_id")]
    pub benchmark_id: String,
    #[serde(rename = "benchmark_version")]
    pub benchmark_version: String,
    /// The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
    #[serde(rename = "manifest_sha256")]
    pub manifest_sha256: String,
    #[serde(rename = "policy")]
    pub policy: Box<models::PolicyInfo>,
    /// A `RunMode`, or one of a later version; `pull` when absent.
    #[serde(rename = "mode", skip_serializing_if = "Option::is_none")]
    pub mode: Option<String>,
    #[serde(rename = "policy_server", skip_serializing_if = "Option::is_none")]
    pub policy_server: Option<models::PolicyServerView>,
    /// Whether workers may play for another policy than `policy`; for the profile `attribution`.
    #[serde(rename = "any_policy", skip_serializing_if = "Option::is_none")]
    pub any_policy: Option<bool>,
    #[serde(rename = "select", skip_serializing_if = "Option::is_none")]
    pub select: Option<models::SelectionView>,
    #[serde(rename = "max_workers")]
    pub max_workers: i32,
    #[serde(rename = "idle_timeout_s")]
    pub idle_timeout_s: f64,
    #[serde(rename = "images")]
    pub images: Box<models::ImageChoice>,
    /// Base URL of the data plane for this run; the path of an operation is appended to it.
    #[serde(rename = "endpoint")]
    pub endpoint: String,
    /// 1 is next; null unless queued.
    #[serde(rename = "queue_position", deserialize_with = "Option::deserialize")]
    pub queue_position: Option<i32>,
    #[serde(rename = "live_workers")]
    pub live_workers: i32,
    #[serde(rename = "progress")]
    pub progress: models::Progress,
    #[serde(rename = "created_at")]
    pub created_at: chrono::DateTime<chrono::FixedOffset>,
    #[serde(rename = "updated_at")]
    pub updated_at: chrono::DateTime<chrono::FixedOffset>,
    /// In how many runs of this benchmark its submitter had executed an action before the first one of this run, whether they were deleted or not; absent before that action. For the profile `deletion`.
    #[serde(rename = "runs_played_before", skip_serializing_if = "Option::is_none")]
    pub runs_played_before: Option<i32>,
    /// How many runs of this benchmark its submitter had submitted, this one included; for the profile `record`.
    #[serde(rename = "attempts_by_submitter", skip_serializing_if = "Option::is_none")]
    pub attempts_by_submitter: Option<i32>,
}

impl Run {
    pub fn new(run_id: String, state: models::RunState, reason: Option<String>, retryable: Option<bool>, benchmark_id: String, benchmark_version: String, manifest_sha256: String, policy: models::PolicyInfo, max_workers: i32, idle_timeout_s: f64, images: models::ImageChoice, endpoint: String, queue_position: Option<i32>, live_workers: i32, progress: models::Progress, created_at: chrono::DateTime<chrono::FixedOffset>, updated_at: chrono::DateTime<chrono::FixedOffset>) -> Run {
        Run {
            run_id,
            state,
            reason,
            retryable,
            benchmark_id,
            benchmark_version,
            manifest_sha256,
            policy: Box::new(policy),
            mode: None,
            policy_server: None,
            any_policy: None,
            select: None,
            max_workers,
            idle_timeout_s,
            images: Box::new(images),
            endpoint,
            queue_position,
            live_workers,
            progress,
            created_at,
            updated_at,
            runs_played_before: None,
            attempts_by_submitter: None,
        }
    }
}
