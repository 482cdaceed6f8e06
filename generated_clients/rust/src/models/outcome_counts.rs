/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct OutcomeCounts {
    #[serde(rename = "total")]
    pub total: i32,
    #[serde(rename = "success")]
    pub success: i32,
    #[serde(rename = "failure")]
    pub failure: i32,
    #[serde(rename = "abandoned")]
    pub abandoned: i32,
    #[serde(rename = "unscored")]
    pub unscored: i32,
}

impl OutcomeCounts {
    pub fn new(total: i32, success: i32, failure: i32, abandoned: i32, unscored: i32) -> OutcomeCounts {
        OutcomeCounts {
            total,
            success,
            failure,
            abandoned,
            unscored,
        }
    }
}
