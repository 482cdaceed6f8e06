/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// Interval : 95 % interval.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct Interval {
    #[serde(rename = "low")]
    pub low: f64,
    #[serde(rename = "high")]
    pub high: f64,
}

impl Interval {
    /// 95 % interval.
    pub fn new(low: f64, high: f64) -> Interval {
        Interval {
            low,
            high,
        }
    }
}
