/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// ReplayDivergence : The first state that was another one; absent where every state was met.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct ReplayDivergence {
    #[serde(rename = "episode_index")]
    pub episode_index: i32,
    #[serde(rename = "attempt")]
    pub attempt: i64,
    /// After how many steps of the attempt the state was another one.
    #[serde(rename = "step")]
    pub step: i64,
}

impl ReplayDivergence {
    /// The first state that was another one; absent where every state was met.
    pub fn new(episode_index: i32, attempt: i64, step: i64) -> ReplayDivergence {
        ReplayDivergence {
            episode_index,
            attempt,
            step,
        }
    }
}
