/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct BenchmarkList {
    #[serde(rename = "benchmarks")]
    pub benchmarks: Vec<models::BenchmarkSummary>,
}

impl BenchmarkList {
    pub fn new(benchmarks: Vec<models::BenchmarkSummary>) -> BenchmarkList {
        BenchmarkList {
            benchmarks,
        }
    }
}
