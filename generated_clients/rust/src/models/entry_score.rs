/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// EntryScore : Of the `get_score` of the run.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct EntryScore {
    #[serde(rename = "score")]
    pub score: f64,
    #[serde(rename = "success_rate")]
    pub success_rate: f64,
    #[serde(rename = "success_interval")]
    pub success_interval: models::Interval,
    #[serde(rename = "mean_interval")]
    pub mean_interval: models::Interval,
    #[serde(rename = "counts")]
    pub counts: models::OutcomeCounts,
    /// Absent where the server does not show it, such as for many tasks.
    #[serde(rename = "by_task", skip_serializing_if = "Option::is_none")]
    pub by_task: Option<std::collections::HashMap<String, models::GroupScore>>,
    /// Absent where the server does not show it, such as for many splits.
    #[serde(rename = "by_split", skip_serializing_if = "Option::is_none")]
    pub by_split: Option<std::collections::HashMap<String, models::GroupScore>>,
}

impl EntryScore {
    /// Of the `get_score` of the run.
    pub fn new(score: f64, success_rate: f64, success_interval: models::Interval, mean_interval: models::Interval, counts: models::OutcomeCounts) -> EntryScore {
        EntryScore {
            score,
            success_rate,
            success_interval,
            mean_interval,
            counts,
            by_task: None,
            by_split: None,
        }
    }
}
