/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// RankInterval : The ranks that an entry may have; absent for an entry that is flagged.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct RankInterval {
    /// The best one.
    #[serde(rename = "low")]
    pub low: i32,
    /// The worst one.
    #[serde(rename = "high")]
    pub high: i32,
}

impl RankInterval {
    /// The ranks that an entry may have; absent for an entry that is flagged.
    pub fn new(low: i32, high: i32) -> RankInterval {
        RankInterval {
            low,
            high,
        }
    }
}
