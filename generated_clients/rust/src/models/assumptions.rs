/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// Assumptions : What the policy takes for granted; refused when the benchmark says otherwise (ATT-010).
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct Assumptions {
    #[serde(rename = "control_rate_hz", skip_serializing_if = "Option::is_none")]
    pub control_rate_hz: Option<f64>,
    #[serde(rename = "action", skip_serializing_if = "Option::is_none")]
    pub action: Option<std::collections::HashMap<String, models::Assumption>>,
    #[serde(rename = "state", skip_serializing_if = "Option::is_none")]
    pub state: Option<std::collections::HashMap<String, models::Assumption>>,
}

impl Assumptions {
    /// What the policy takes for granted; refused when the benchmark says otherwise (ATT-010).
    pub fn new() -> Assumptions {
        Assumptions {
            control_rate_hz: None,
            action: None,
            state: None,
        }
    }
}
