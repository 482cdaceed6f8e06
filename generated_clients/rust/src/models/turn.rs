/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// Turn : The answer to attach (seq 0) and to predict.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct Turn {
    #[serde(rename = "session_id")]
    pub session_id: String,
    #[serde(rename = "seq")]
    pub seq: i64,
    #[serde(rename = "episode", skip_serializing_if = "Option::is_none")]
    pub episode: Option<models::EpisodeView>,
    #[serde(rename = "observation", skip_serializing_if = "Option::is_none")]
    pub observation: Option<models::Observation>,
    /// With `observe` all, one per executed action.
    #[serde(rename = "observations", skip_serializing_if = "Option::is_none")]
    pub observations: Option<Vec<models::Observation>>,
    #[serde(rename = "executed_steps")]
    pub executed_steps: i32,
    /// The episode ended before the chunk did.
    #[serde(rename = "stopped_early")]
    pub stopped_early: bool,
    /// One per executed action.
    #[serde(rename = "rewards")]
    pub rewards: Vec<f64>,
    /// The task ended by itself in this turn.
    #[serde(rename = "terminated")]
    pub terminated: bool,
    /// The step limit ended the episode in this turn.
    #[serde(rename = "truncated")]
    pub truncated: bool,
    #[serde(rename = "episode_result", skip_serializing_if = "Option::is_none")]
    pub episode_result: Option<models::EpisodeResult>,
    #[serde(rename = "fault", skip_serializing_if = "Option::is_none")]
    pub fault: Option<models::Fault>,
    /// No episode is left for this session. It holds no slot any more; its last turn can be repeated until its lease ends.
    #[serde(rename = "done")]
    pub done: bool,
    #[serde(rename = "lease")]
    pub lease: models::Lease,
    #[serde(rename = "timing")]
    pub timing: models::Timing,
}

impl Turn {
    /// The answer to attach (seq 0) and to predict.
    pub fn new(session_id: String, seq: i64, executed_steps: i32, stopped_early: bool, rewards: Vec<f64>, terminated: bool, truncated: bool, done: bool, lease: models::Lease, timing: models::Timing) -> Turn {
        Turn {
            session_id,
            seq,
            episode: None,
            observation: None,
            observations: None,
            executed_steps,
            stopped_early,
            rewards,
            terminated,
            truncated,
            episode_result: None,
            fault: None,
            done,
            lease,
            timing,
        }
    }
}
