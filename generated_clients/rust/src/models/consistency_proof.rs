/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct ConsistencyProof {
    #[serde(rename = "old_size")]
    pub old_size: i64,
    #[serde(rename = "new_size")]
    pub new_size: i64,
    #[serde(rename = "hashes")]
    pub hashes: Vec<String>,
}

impl ConsistencyProof {
    pub fn new(old_size: i64, new_size: i64, hashes: Vec<String>) -> ConsistencyProof {
        ConsistencyProof {
            old_size,
            new_size,
            hashes,
        }
    }
}
