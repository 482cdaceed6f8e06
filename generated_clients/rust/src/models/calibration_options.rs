/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// CalibrationOptions : Only for the benchmark `calibration`, which the submitter shapes.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct CalibrationOptions {
    /// One entry per episode, in order; one `score` episode when absent.
    #[serde(rename = "tasks", skip_serializing_if = "Option::is_none")]
    pub tasks: Option<Vec<models::CalibrationTask>>,
    /// 10 when absent.
    #[serde(rename = "max_steps", skip_serializing_if = "Option::is_none")]
    pub max_steps: Option<i32>,
    #[serde(rename = "success_rule", skip_serializing_if = "Option::is_none")]
    pub success_rule: Option<models::SuccessRule>,
    /// 3 when absent.
    #[serde(rename = "max_attempts", skip_serializing_if = "Option::is_none")]
    pub max_attempts: Option<i32>,
    /// 3 when absent.
    #[serde(rename = "max_faults", skip_serializing_if = "Option::is_none")]
    pub max_faults: Option<i32>,
    /// Whether the seeds of the split `odd` are sealed; false when absent. Only for servers that announce the profile `sealed_seeds`.
    #[serde(rename = "sealed", skip_serializing_if = "Option::is_none")]
    pub sealed: Option<bool>,
    /// Seconds for which the run stays queued after submit and after resume; 0 when absent.
    #[serde(rename = "queue_s", skip_serializing_if = "Option::is_none")]
    pub queue_s: Option<f64>,
}

impl CalibrationOptions {
    /// Only for the benchmark `calibration`, which the submitter shapes.
    pub fn new() -> CalibrationOptions {
        CalibrationOptions {
            tasks: None,
            max_steps: None,
            success_rule: None,
            max_attempts: None,
            max_faults: None,
            sealed: None,
            queue_s: None,
        }
    }
}
