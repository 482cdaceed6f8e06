/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// RecordReplay : As in a verdict (record.md); absent before the end of the replay, and where there is none.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct RecordReplay {
    /// `exact`, `outcome` or `diverged`.
    #[serde(rename = "result")]
    pub result: String,
    #[serde(rename = "episodes")]
    pub episodes: i32,
    #[serde(rename = "exact")]
    pub exact: i32,
    #[serde(rename = "outcome")]
    pub outcome: i32,
    #[serde(rename = "diverged")]
    pub diverged: i32,
    #[serde(rename = "first_divergence", skip_serializing_if = "Option::is_none")]
    pub first_divergence: Option<models::ReplayDivergence>,
}

impl RecordReplay {
    /// As in a verdict (record.md); absent before the end of the replay, and where there is none.
    pub fn new(result: String, episodes: i32, exact: i32, outcome: i32, diverged: i32) -> RecordReplay {
        RecordReplay {
            result,
            episodes,
            exact,
            outcome,
            diverged,
            first_divergence: None,
        }
    }
}
