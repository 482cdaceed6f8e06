/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct Limits {
    /// Longest request body that is read.
    #[serde(rename = "max_body_bytes")]
    pub max_body_bytes: i64,
    /// Most live workers a run may ask for.
    #[serde(rename = "max_workers")]
    pub max_workers: i32,
    /// Most actions in one predict; a benchmark may allow fewer.
    #[serde(rename = "max_chunk")]
    pub max_chunk: i32,
    #[serde(rename = "idle_timeout_s_min")]
    pub idle_timeout_s_min: f64,
    #[serde(rename = "idle_timeout_s_max")]
    pub idle_timeout_s_max: f64,
    /// Longest wait that a long-poll is granted.
    #[serde(rename = "wait_s_max")]
    pub wait_s_max: i32,
    /// Longest request line with its headers that is read; for the profile `limits`.
    #[serde(rename = "max_header_bytes", skip_serializing_if = "Option::is_none")]
    pub max_header_bytes: Option<i32>,
    /// Time in which the headers of a request are complete, from its first byte; for the profile `limits`.
    #[serde(rename = "header_timeout_s", skip_serializing_if = "Option::is_none")]
    pub header_timeout_s: Option<f64>,
    /// Time in which a part of a body arrives after the headers of its request; for the profile `limits`.
    #[serde(rename = "body_timeout_s", skip_serializing_if = "Option::is_none")]
    pub body_timeout_s: Option<f64>,
    /// Longest time that a session lives without a new turn, whatever its `idle_timeout_s`; for the profile `limits`.
    #[serde(rename = "heartbeat_s_max", skip_serializing_if = "Option::is_none")]
    pub heartbeat_s_max: Option<f64>,
    /// When others wait: the time after which a run without a worker, or a session without a turn, may make room; for the profile `limits`.
    #[serde(rename = "unused_s_max", skip_serializing_if = "Option::is_none")]
    pub unused_s_max: Option<f64>,
    /// Longest body that is read of a request other than `predict`, where it is less than `max_body_bytes`; for the profile `limits`.
    #[serde(rename = "max_control_body_bytes", skip_serializing_if = "Option::is_none")]
    pub max_control_body_bytes: Option<i64>,
    /// Most runs of one account that are queued, ready, running or stopping; for the profile `limits`.
    #[serde(rename = "max_open_runs", skip_serializing_if = "Option::is_none")]
    pub max_open_runs: Option<i32>,
    /// Most Idempotency-Keys that one account may use; for the profile `limits`.
    #[serde(rename = "max_idempotency_keys", skip_serializing_if = "Option::is_none")]
    pub max_idempotency_keys: Option<i64>,
    /// Most bytes that the submissions of one account may have together; what else a server stores for a run may count, too. For the profile `limits`.
    #[serde(rename = "max_stored_bytes", skip_serializing_if = "Option::is_none")]
    pub max_stored_bytes: Option<i64>,
    /// Longest archive that `import_record` reads; for the profile `record_import`.
    #[serde(rename = "max_record_bytes", skip_serializing_if = "Option::is_none")]
    pub max_record_bytes: Option<i64>,
    /// Most imports of one account that are not `finished`; for the profile `record_import`.
    #[serde(rename = "max_waiting_imports", skip_serializing_if = "Option::is_none")]
    pub max_waiting_imports: Option<i32>,
    /// Most bytes that the archives of one account may have together; for the profile `record_import`.
    #[serde(rename = "max_imported_bytes", skip_serializing_if = "Option::is_none")]
    pub max_imported_bytes: Option<i64>,
    /// Days without a change after which a run that has completed, failed or been stopped may be deleted; when absent, none is. For the profile `deletion`.
    #[serde(rename = "run_keep_days", skip_serializing_if = "Option::is_none")]
    pub run_keep_days: Option<f64>,
}

impl Limits {
    pub fn new(max_body_bytes: i64, max_workers: i32, max_chunk: i32, idle_timeout_s_min: f64, idle_timeout_s_max: f64, wait_s_max: i32) -> Limits {
        Limits {
            max_body_bytes,
            max_workers,
            max_chunk,
            idle_timeout_s_min,
            idle_timeout_s_max,
            wait_s_max,
            max_header_bytes: None,
            header_timeout_s: None,
            body_timeout_s: None,
            heartbeat_s_max: None,
            unused_s_max: None,
            max_control_body_bytes: None,
            max_open_runs: None,
            max_idempotency_keys: None,
            max_stored_bytes: None,
            max_record_bytes: None,
            max_waiting_imports: None,
            max_imported_bytes: None,
            run_keep_days: None,
        }
    }
}
