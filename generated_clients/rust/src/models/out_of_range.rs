/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

///
#[derive(Clone, Copy, Debug, Eq, PartialEq, Ord, PartialOrd, Hash, Serialize, Deserialize)]
pub enum OutOfRange {
    #[serde(rename = "refuse")]
    Refuse,
    #[serde(rename = "clip")]
    Clip,
    #[serde(rename = "unbounded")]
    Unbounded,

}

impl std::fmt::Display for OutOfRange {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            Self::Refuse => write!(f, "refuse"),
            Self::Clip => write!(f, "clip"),
            Self::Unbounded => write!(f, "unbounded"),
        }
    }
}

impl Default for OutOfRange {
    fn default() -> OutOfRange {
        Self::Refuse
    }
}
