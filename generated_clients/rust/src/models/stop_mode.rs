/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// StopMode : `abort` when absent.
/// `abort` when absent.
#[derive(Clone, Copy, Debug, Eq, PartialEq, Ord, PartialOrd, Hash, Serialize, Deserialize)]
pub enum StopMode {
    #[serde(rename = "abort")]
    Abort,
    #[serde(rename = "drain")]
    Drain,

}

impl std::fmt::Display for StopMode {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            Self::Abort => write!(f, "abort"),
            Self::Drain => write!(f, "drain"),
        }
    }
}

impl Default for StopMode {
    fn default() -> StopMode {
        Self::Abort
    }
}
