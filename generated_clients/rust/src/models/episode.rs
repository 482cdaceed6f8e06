/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct Episode {
    #[serde(rename = "episode_id")]
    pub episode_id: String,
    #[serde(rename = "index")]
    pub index: i32,
    #[serde(rename = "task")]
    pub task: String,
    #[serde(rename = "split")]
    pub split: String,
    #[serde(rename = "status")]
    pub status: models::EpisodeStatus,
    /// The current or next attempt.
    #[serde(rename = "attempt")]
    pub attempt: i32,
    #[serde(rename = "faults")]
    pub faults: i32,
    /// In a run with mode `push`: what the policy did wrong when it last ended an attempt of this episode.
    #[serde(rename = "policy_fault", skip_serializing_if = "Option::is_none")]
    pub policy_fault: Option<String>,
    #[serde(rename = "result", skip_serializing_if = "Option::is_none")]
    pub result: Option<models::EpisodeResult>,
}

impl Episode {
    pub fn new(episode_id: String, index: i32, task: String, split: String, status: models::EpisodeStatus, attempt: i32, faults: i32) -> Episode {
        Episode {
            episode_id,
            index,
            task,
            split,
            status,
            attempt,
            faults,
            policy_fault: None,
            result: None,
        }
    }
}
