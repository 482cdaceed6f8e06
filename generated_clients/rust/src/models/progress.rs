/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct Progress {
    #[serde(rename = "episodes_total")]
    pub episodes_total: i32,
    /// Abandoned ones included.
    #[serde(rename = "episodes_scored")]
    pub episodes_scored: i32,
    #[serde(rename = "episodes_in_progress")]
    pub episodes_in_progress: i32,
    #[serde(rename = "episodes_pending")]
    pub episodes_pending: i32,
}

impl Progress {
    pub fn new(episodes_total: i32, episodes_scored: i32, episodes_in_progress: i32, episodes_pending: i32) -> Progress {
        Progress {
            episodes_total,
            episodes_scored,
            episodes_in_progress,
            episodes_pending,
        }
    }
}
