/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct EpisodeResult {
    #[serde(rename = "episode_id")]
    pub episode_id: String,
    #[serde(rename = "index")]
    pub index: i32,
    #[serde(rename = "task")]
    pub task: String,
    #[serde(rename = "split")]
    pub split: String,
    /// Absent where `sealed_splits` of the benchmark names the split.
    #[serde(rename = "seed", skip_serializing_if = "Option::is_none")]
    pub seed: Option<i64>,
    #[serde(rename = "attempt")]
    pub attempt: i32,
    #[serde(rename = "faults")]
    pub faults: i32,
    #[serde(rename = "outcome")]
    pub outcome: models::Outcome,
    #[serde(rename = "score")]
    pub score: f64,
    #[serde(rename = "steps")]
    pub steps: i32,
    #[serde(rename = "terminated")]
    pub terminated: bool,
    #[serde(rename = "truncated")]
    pub truncated: bool,
    /// Time between turns that the policy took.
    #[serde(rename = "think_s")]
    pub think_s: f64,
    #[serde(rename = "finished_at")]
    pub finished_at: chrono::DateTime<chrono::FixedOffset>,
    #[serde(rename = "player", skip_serializing_if = "Option::is_none")]
    pub player: Option<models::PlayerView>,
    /// Actions of the attempt with a number outside of a range that is declared `clip`; for the profile `attribution`.
    #[serde(rename = "clipped_actions", skip_serializing_if = "Option::is_none")]
    pub clipped_actions: Option<i32>,
    /// Sum of the rewards of the attempt, its return; for the profile `attribution`.
    #[serde(rename = "total_reward", skip_serializing_if = "Option::is_none")]
    pub total_reward: Option<f64>,
}

impl EpisodeResult {
    pub fn new(episode_id: String, index: i32, task: String, split: String, attempt: i32, faults: i32, outcome: models::Outcome, score: f64, steps: i32, terminated: bool, truncated: bool, think_s: f64, finished_at: chrono::DateTime<chrono::FixedOffset>) -> EpisodeResult {
        EpisodeResult {
            episode_id,
            index,
            task,
            split,
            seed: None,
            attempt,
            faults,
            outcome,
            score,
            steps,
            terminated,
            truncated,
            think_s,
            finished_at,
            player: None,
            clipped_actions: None,
            total_reward: None,
        }
    }
}
