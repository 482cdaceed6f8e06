/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// RunMode : `pull` when absent: workers attach and predict. `push`: the server calls the policy itself, and workers of the run are its own.
/// `pull` when absent: workers attach and predict. `push`: the server calls the policy itself, and workers of the run are its own.
#[derive(Clone, Copy, Debug, Eq, PartialEq, Ord, PartialOrd, Hash, Serialize, Deserialize)]
pub enum RunMode {
    #[serde(rename = "pull")]
    Pull,
    #[serde(rename = "push")]
    Push,

}

impl std::fmt::Display for RunMode {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            Self::Pull => write!(f, "pull"),
            Self::Push => write!(f, "push"),
        }
    }
}

impl Default for RunMode {
    fn default() -> RunMode {
        Self::Pull
    }
}
