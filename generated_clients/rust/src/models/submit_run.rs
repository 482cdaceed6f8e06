/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct SubmitRun {
    #[serde(rename = "benchmark_id")]
    pub benchmark_id: String,
    #[serde(rename = "policy")]
    pub policy: Box<models::PolicyInfo>,
    /// Most live workers wanted; the server's limit when absent.
    #[serde(rename = "max_workers", skip_serializing_if = "Option::is_none")]
    pub max_workers: Option<i32>,
    /// Lease of a session; the server's maximum when absent.
    #[serde(rename = "idle_timeout_s", skip_serializing_if = "Option::is_none")]
    pub idle_timeout_s: Option<f64>,
    #[serde(rename = "images", skip_serializing_if = "Option::is_none")]
    pub images: Option<Box<models::ImageChoice>>,
    #[serde(rename = "options", skip_serializing_if = "Option::is_none")]
    pub options: Option<Box<models::CalibrationOptions>>,
    #[serde(rename = "mode", skip_serializing_if = "Option::is_none")]
    pub mode: Option<models::RunMode>,
    #[serde(rename = "policy_server", skip_serializing_if = "Option::is_none")]
    pub policy_server: Option<Box<models::PolicyServer>>,
    /// Workers may play for another policy than `policy`; false when absent; for the profile `attribution`.
    #[serde(rename = "any_policy", skip_serializing_if = "Option::is_none")]
    pub any_policy: Option<bool>,
    #[serde(rename = "select", skip_serializing_if = "Option::is_none")]
    pub select: Option<Box<models::EpisodeSelection>>,
}

impl SubmitRun {
    pub fn new(benchmark_id: String, policy: models::PolicyInfo) -> SubmitRun {
        SubmitRun {
            benchmark_id,
            policy: Box::new(policy),
            max_workers: None,
            idle_timeout_s: None,
            images: None,
            options: None,
            mode: None,
            policy_server: None,
            any_policy: None,
            select: None,
        }
    }
}
