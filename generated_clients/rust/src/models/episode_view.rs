/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// EpisodeView : The episode that the observation belongs to.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct EpisodeView {
    #[serde(rename = "episode_id")]
    pub episode_id: String,
    /// Position in the manifest.
    #[serde(rename = "index")]
    pub index: i32,
    #[serde(rename = "task")]
    pub task: String,
    #[serde(rename = "instruction")]
    pub instruction: String,
    #[serde(rename = "attempt")]
    pub attempt: i32,
    #[serde(rename = "step")]
    pub step: i32,
    #[serde(rename = "max_steps")]
    pub max_steps: i32,
}

impl EpisodeView {
    /// The episode that the observation belongs to.
    pub fn new(episode_id: String, index: i32, task: String, instruction: String, attempt: i32, step: i32, max_steps: i32) -> EpisodeView {
        EpisodeView {
            episode_id,
            index,
            task,
            instruction,
            attempt,
            step,
            max_steps,
        }
    }
}
