/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct HistoryLeaf {
    #[serde(rename = "index")]
    pub index: i64,
    /// A JSON text, whose UTF-8 is what the tree has; board.md has its members.
    #[serde(rename = "leaf")]
    pub leaf: String,
}

impl HistoryLeaf {
    pub fn new(index: i64, leaf: String) -> HistoryLeaf {
        HistoryLeaf {
            index,
            leaf,
        }
    }
}
