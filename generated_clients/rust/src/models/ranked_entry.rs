/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct RankedEntry {
    #[serde(rename = "entry")]
    pub entry: models::BoardEntry,
    #[serde(rename = "rank", skip_serializing_if = "Option::is_none")]
    pub rank: Option<models::RankInterval>,
    /// How many entries are significantly better; 0 without a rank.
    #[serde(rename = "better")]
    pub better: i32,
    /// How many entries are significantly worse; 0 without a rank.
    #[serde(rename = "worse")]
    pub worse: i32,
    /// Entries that cannot be distinguished have a letter in common, others have none in common; empty without a rank.
    #[serde(rename = "letters")]
    pub letters: Vec<String>,
}

impl RankedEntry {
    pub fn new(entry: models::BoardEntry, better: i32, worse: i32, letters: Vec<String>) -> RankedEntry {
        RankedEntry {
            entry,
            rank: None,
            better,
            worse,
            letters,
        }
    }
}
