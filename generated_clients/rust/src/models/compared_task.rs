/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct ComparedTask {
    #[serde(rename = "paired")]
    pub paired: i32,
    #[serde(rename = "baseline_mean", deserialize_with = "Option::deserialize")]
    pub baseline_mean: Option<f64>,
    #[serde(rename = "mean", deserialize_with = "Option::deserialize")]
    pub mean: Option<f64>,
    #[serde(rename = "difference", deserialize_with = "Option::deserialize")]
    pub difference: Option<f64>,
}

impl ComparedTask {
    pub fn new(paired: i32, baseline_mean: Option<f64>, mean: Option<f64>, difference: Option<f64>) -> ComparedTask {
        ComparedTask {
            paired,
            baseline_mean,
            mean,
            difference,
        }
    }
}
