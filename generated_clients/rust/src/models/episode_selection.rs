/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// EpisodeSelection : The part of a benchmark that is played, all of it where a member is absent; for the profile `subsets`.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct EpisodeSelection {
    #[serde(rename = "tasks", skip_serializing_if = "Option::is_none")]
    pub tasks: Option<Vec<String>>,
    #[serde(rename = "splits", skip_serializing_if = "Option::is_none")]
    pub splits: Option<Vec<String>>,
}

impl EpisodeSelection {
    /// The part of a benchmark that is played, all of it where a member is absent; for the profile `subsets`.
    pub fn new() -> EpisodeSelection {
        EpisodeSelection {
            tasks: None,
            splits: None,
        }
    }
}
