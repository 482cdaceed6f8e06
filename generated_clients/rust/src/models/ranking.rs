/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// Ranking : See board.md for every number here.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ranking {
    #[serde(rename = "benchmark_id")]
    pub benchmark_id: String,
    /// The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
    #[serde(rename = "manifest_sha256")]
    pub manifest_sha256: String,
    /// How many episodes each entry has; null where the manifest has no entry.
    #[serde(rename = "episodes_total", deserialize_with = "Option::deserialize")]
    pub episodes_total: Option<i32>,
    /// How many entries have a rank.
    #[serde(rename = "ranked")]
    pub ranked: i32,
    /// How many pairs of them were tested.
    #[serde(rename = "comparisons")]
    pub comparisons: i64,
    /// How likely it is at most that any two equally good policies are distinguished; 0.05.
    #[serde(rename = "alpha")]
    pub alpha: f64,
    /// Two entries that differ on fewer episodes can never be distinguished; null if the benchmark has fewer episodes.
    #[serde(rename = "differing_min", deserialize_with = "Option::deserialize")]
    pub differing_min: Option<i32>,
    /// Two entries that differ on so many episodes, all to the advantage of one, are distinguished, however the others fared; null if the benchmark has fewer episodes.
    #[serde(rename = "differing_enough", deserialize_with = "Option::deserialize")]
    pub differing_enough: Option<i32>,
    #[serde(rename = "rows")]
    pub rows: Vec<models::RankedEntry>,
    #[serde(rename = "next_cursor", deserialize_with = "Option::deserialize")]
    pub next_cursor: Option<String>,
}

impl Ranking {
    /// See board.md for every number here.
    pub fn new(benchmark_id: String, manifest_sha256: String, episodes_total: Option<i32>, ranked: i32, comparisons: i64, alpha: f64, differing_min: Option<i32>, differing_enough: Option<i32>, rows: Vec<models::RankedEntry>, next_cursor: Option<String>) -> Ranking {
        Ranking {
            benchmark_id,
            manifest_sha256,
            episodes_total,
            ranked,
            comparisons,
            alpha,
            differing_min,
            differing_enough,
            rows,
            next_cursor,
        }
    }
}
