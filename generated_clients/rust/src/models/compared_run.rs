/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// ComparedRun : One run beside the baseline. A pair is an episode that both have scored.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct ComparedRun {
    #[serde(rename = "run_id")]
    pub run_id: String,
    /// Both runs have scored every episode.
    #[serde(rename = "complete")]
    pub complete: bool,
    /// Complete, and no difference, over all episodes or over those of a task, is beyond the tolerance.
    #[serde(rename = "release")]
    pub release: bool,
    /// Number of pairs.
    #[serde(rename = "paired")]
    pub paired: i32,
    /// Mean score of the baseline over the pairs.
    #[serde(rename = "baseline_mean", deserialize_with = "Option::deserialize")]
    pub baseline_mean: Option<f64>,
    /// Mean score of the run over the pairs.
    #[serde(rename = "mean", deserialize_with = "Option::deserialize")]
    pub mean: Option<f64>,
    /// Baseline minus run: positive when the run is worse.
    #[serde(rename = "difference", deserialize_with = "Option::deserialize")]
    pub difference: Option<f64>,
    /// Pairs in which the run alone succeeds.
    #[serde(rename = "wins")]
    pub wins: i32,
    /// Pairs in which the baseline alone succeeds.
    #[serde(rename = "losses")]
    pub losses: i32,
    /// Pairs in which both succeed or neither does.
    #[serde(rename = "ties")]
    pub ties: i32,
    /// McNemar's exact test, two-sided.
    #[serde(rename = "p_value")]
    pub p_value: f64,
    /// Task → the pairs of its episodes.
    #[serde(rename = "by_task")]
    pub by_task: std::collections::HashMap<String, models::ComparedTask>,
}

impl ComparedRun {
    /// One run beside the baseline. A pair is an episode that both have scored.
    pub fn new(run_id: String, complete: bool, release: bool, paired: i32, baseline_mean: Option<f64>, mean: Option<f64>, difference: Option<f64>, wins: i32, losses: i32, ties: i32, p_value: f64, by_task: std::collections::HashMap<String, models::ComparedTask>) -> ComparedRun {
        ComparedRun {
            run_id,
            complete,
            release,
            paired,
            baseline_mean,
            mean,
            difference,
            wins,
            losses,
            ties,
            p_value,
            by_task,
        }
    }
}
