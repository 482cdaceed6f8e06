/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// ResetPolicy : An attempt begins; whatever the policy remembers of this session is over.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct ResetPolicy {
    #[serde(rename = "session_id")]
    pub session_id: String,
    #[serde(rename = "run_id", skip_serializing_if = "Option::is_none")]
    pub run_id: Option<String>,
    #[serde(rename = "benchmark")]
    pub benchmark: models::Benchmark,
    #[serde(rename = "episode")]
    pub episode: models::EpisodeView,
}

impl ResetPolicy {
    /// An attempt begins; whatever the policy remembers of this session is over.
    pub fn new(session_id: String, benchmark: models::Benchmark, episode: models::EpisodeView) -> ResetPolicy {
        ResetPolicy {
            session_id,
            run_id: None,
            benchmark,
            episode,
        }
    }
}
