/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

///
#[derive(Clone, Copy, Debug, Eq, PartialEq, Ord, PartialOrd, Hash, Serialize, Deserialize)]
pub enum EntryState {
    #[serde(rename = "published")]
    Published,
    #[serde(rename = "withdrawn")]
    Withdrawn,

}

impl std::fmt::Display for EntryState {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            Self::Published => write!(f, "published"),
            Self::Withdrawn => write!(f, "withdrawn"),
        }
    }
}

impl Default for EntryState {
    fn default() -> EntryState {
        Self::Published
    }
}
