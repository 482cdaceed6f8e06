/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// PolicyReset : The policy is ready for this attempt and no other.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct PolicyReset {
    #[serde(rename = "session_id")]
    pub session_id: String,
    #[serde(rename = "episode_id")]
    pub episode_id: String,
    #[serde(rename = "attempt")]
    pub attempt: i32,
}

impl PolicyReset {
    /// The policy is ready for this attempt and no other.
    pub fn new(session_id: String, episode_id: String, attempt: i32) -> PolicyReset {
        PolicyReset {
            session_id,
            episode_id,
            attempt,
        }
    }
}
