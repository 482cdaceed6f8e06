/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct InclusionProof {
    #[serde(rename = "leaf_index")]
    pub leaf_index: i64,
    #[serde(rename = "tree_size")]
    pub tree_size: i64,
    #[serde(rename = "hashes")]
    pub hashes: Vec<String>,
}

impl InclusionProof {
    pub fn new(leaf_index: i64, tree_size: i64, hashes: Vec<String>) -> InclusionProof {
        InclusionProof {
            leaf_index,
            tree_size,
            hashes,
        }
    }
}
