/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct GroupScore {
    #[serde(rename = "counts")]
    pub counts: models::OutcomeCounts,
    #[serde(rename = "mean", deserialize_with = "Option::deserialize")]
    pub mean: Option<f64>,
    #[serde(rename = "success_rate", deserialize_with = "Option::deserialize")]
    pub success_rate: Option<f64>,
}

impl GroupScore {
    pub fn new(counts: models::OutcomeCounts, mean: Option<f64>, success_rate: Option<f64>) -> GroupScore {
        GroupScore {
            counts,
            mean,
            success_rate,
        }
    }
}
