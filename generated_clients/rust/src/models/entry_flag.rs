/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct EntryFlag {
    #[serde(rename = "reason")]
    pub reason: String,
    #[serde(rename = "flagged_at")]
    pub flagged_at: chrono::DateTime<chrono::FixedOffset>,
}

impl EntryFlag {
    pub fn new(reason: String, flagged_at: chrono::DateTime<chrono::FixedOffset>) -> EntryFlag {
        EntryFlag {
            reason,
            flagged_at,
        }
    }
}
