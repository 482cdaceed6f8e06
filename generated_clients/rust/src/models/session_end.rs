/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// SessionEnd : What ended the session, as far as the server still knows; `unknown` after a restart, and for a session that was taken over and whose successor has ended.
/// What ended the session, as far as the server still knows; `unknown` after a restart, and for a session that was taken over and whose successor has ended.
#[derive(Clone, Copy, Debug, Eq, PartialEq, Ord, PartialOrd, Hash, Serialize, Deserialize)]
pub enum SessionEnd {
    #[serde(rename = "lease_ended")]
    LeaseEnded,
    #[serde(rename = "detached")]
    Detached,
    #[serde(rename = "run_stopped")]
    RunStopped,
    #[serde(rename = "run_failed")]
    RunFailed,
    #[serde(rename = "unknown")]
    Unknown,

}

impl std::fmt::Display for SessionEnd {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            Self::LeaseEnded => write!(f, "lease_ended"),
            Self::Detached => write!(f, "detached"),
            Self::RunStopped => write!(f, "run_stopped"),
            Self::RunFailed => write!(f, "run_failed"),
            Self::Unknown => write!(f, "unknown"),
        }
    }
}

impl Default for SessionEnd {
    fn default() -> SessionEnd {
        Self::LeaseEnded
    }
}
