/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct BenchmarkSummary {
    #[serde(rename = "benchmark_id")]
    pub benchmark_id: String,
    #[serde(rename = "version")]
    pub version: String,
    #[serde(rename = "title")]
    pub title: String,
    /// The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
    #[serde(rename = "manifest_sha256")]
    pub manifest_sha256: String,
    #[serde(rename = "episodes_total")]
    pub episodes_total: i32,
}

impl BenchmarkSummary {
    pub fn new(benchmark_id: String, version: String, title: String, manifest_sha256: String, episodes_total: i32) -> BenchmarkSummary {
        BenchmarkSummary {
            benchmark_id,
            version,
            title,
            manifest_sha256,
            episodes_total,
        }
    }
}
