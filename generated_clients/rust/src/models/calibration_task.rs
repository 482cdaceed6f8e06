/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

///
#[derive(Clone, Copy, Debug, Eq, PartialEq, Ord, PartialOrd, Hash, Serialize, Deserialize)]
pub enum CalibrationTask {
    #[serde(rename = "score")]
    Score,
    #[serde(rename = "count")]
    Count,
    #[serde(rename = "echo")]
    Echo,
    #[serde(rename = "delay")]
    Delay,
    #[serde(rename = "fault")]
    Fault,

}

impl std::fmt::Display for CalibrationTask {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            Self::Score => write!(f, "score"),
            Self::Count => write!(f, "count"),
            Self::Echo => write!(f, "echo"),
            Self::Delay => write!(f, "delay"),
            Self::Fault => write!(f, "fault"),
        }
    }
}

impl Default for CalibrationTask {
    fn default() -> CalibrationTask {
        Self::Score
    }
}
