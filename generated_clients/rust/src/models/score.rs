/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// Score : See scoring.md for every number here.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct Score {
    #[serde(rename = "run_id")]
    pub run_id: String,
    #[serde(rename = "benchmark_id")]
    pub benchmark_id: String,
    /// The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
    #[serde(rename = "manifest_sha256")]
    pub manifest_sha256: String,
    #[serde(rename = "select", skip_serializing_if = "Option::is_none")]
    pub select: Option<models::SelectionView>,
    #[serde(rename = "state")]
    pub state: models::RunState,
    #[serde(rename = "complete")]
    pub complete: bool,
    /// Null until complete.
    #[serde(rename = "score", deserialize_with = "Option::deserialize")]
    pub score: Option<f64>,
    #[serde(rename = "score_low")]
    pub score_low: f64,
    #[serde(rename = "score_high")]
    pub score_high: f64,
    #[serde(rename = "counts")]
    pub counts: models::OutcomeCounts,
    #[serde(rename = "success_rate", deserialize_with = "Option::deserialize")]
    pub success_rate: Option<f64>,
    #[serde(rename = "success_interval")]
    pub success_interval: models::Interval,
    /// Mean over the scored episodes.
    #[serde(rename = "mean", deserialize_with = "Option::deserialize")]
    pub mean: Option<f64>,
    #[serde(rename = "mean_interval")]
    pub mean_interval: models::Interval,
    #[serde(rename = "by_task")]
    pub by_task: std::collections::HashMap<String, models::GroupScore>,
    #[serde(rename = "by_split")]
    pub by_split: std::collections::HashMap<String, models::GroupScore>,
}

impl Score {
    /// See scoring.md for every number here.
    pub fn new(run_id: String, benchmark_id: String, manifest_sha256: String, state: models::RunState, complete: bool, score: Option<f64>, score_low: f64, score_high: f64, counts: models::OutcomeCounts, success_rate: Option<f64>, success_interval: models::Interval, mean: Option<f64>, mean_interval: models::Interval, by_task: std::collections::HashMap<String, models::GroupScore>, by_split: std::collections::HashMap<String, models::GroupScore>) -> Score {
        Score {
            run_id,
            benchmark_id,
            manifest_sha256,
            select: None,
            state,
            complete,
            score,
            score_low,
            score_high,
            counts,
            success_rate,
            success_interval,
            mean,
            mean_interval,
            by_task,
            by_split,
        }
    }
}
