/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct HistoryPage {
    #[serde(rename = "leaves")]
    pub leaves: Vec<models::HistoryLeaf>,
    #[serde(rename = "next_cursor", deserialize_with = "Option::deserialize")]
    pub next_cursor: Option<String>,
}

impl HistoryPage {
    pub fn new(leaves: Vec<models::HistoryLeaf>, next_cursor: Option<String>) -> HistoryPage {
        HistoryPage {
            leaves,
            next_cursor,
        }
    }
}
