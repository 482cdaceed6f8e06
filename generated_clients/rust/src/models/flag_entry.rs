/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct FlagEntry {
    /// False takes the flag back.
    #[serde(rename = "flagged")]
    pub flagged: bool,
    /// Shown with the entry.
    #[serde(rename = "reason")]
    pub reason: String,
}

impl FlagEntry {
    pub fn new(flagged: bool, reason: String) -> FlagEntry {
        FlagEntry {
            flagged,
            reason,
        }
    }
}
