/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// Comparison : See scoring.md for every number here.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct Comparison {
    /// Id of the run that the others are compared with.
    #[serde(rename = "baseline")]
    pub baseline: String,
    #[serde(rename = "benchmark_id")]
    pub benchmark_id: String,
    /// The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
    #[serde(rename = "manifest_sha256")]
    pub manifest_sha256: String,
    #[serde(rename = "tolerance")]
    pub tolerance: f64,
    /// One entry per run that was named, in that order.
    #[serde(rename = "runs")]
    pub runs: Vec<models::ComparedRun>,
}

impl Comparison {
    /// See scoring.md for every number here.
    pub fn new(baseline: String, benchmark_id: String, manifest_sha256: String, tolerance: f64, runs: Vec<models::ComparedRun>) -> Comparison {
        Comparison {
            baseline,
            benchmark_id,
            manifest_sha256,
            tolerance,
            runs,
        }
    }
}
