/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct BoardEntryList {
    #[serde(rename = "entries")]
    pub entries: Vec<models::BoardEntry>,
    #[serde(rename = "next_cursor", deserialize_with = "Option::deserialize")]
    pub next_cursor: Option<String>,
}

impl BoardEntryList {
    pub fn new(entries: Vec<models::BoardEntry>, next_cursor: Option<String>) -> BoardEntryList {
        BoardEntryList {
            entries,
            next_cursor,
        }
    }
}
