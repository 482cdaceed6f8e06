/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

///
#[derive(Clone, Copy, Debug, Eq, PartialEq, Ord, PartialOrd, Hash, Serialize, Deserialize)]
pub enum Profile {
    #[serde(rename = "core")]
    Core,
    #[serde(rename = "msgpack")]
    Msgpack,
    #[serde(rename = "compare")]
    Compare,
    #[serde(rename = "events")]
    Events,
    #[serde(rename = "push")]
    Push,
    #[serde(rename = "ebench")]
    Ebench,
    #[serde(rename = "flageval")]
    Flageval,

}

impl std::fmt::Display for Profile {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            Self::Core => write!(f, "core"),
            Self::Msgpack => write!(f, "msgpack"),
            Self::Compare => write!(f, "compare"),
            Self::Events => write!(f, "events"),
            Self::Push => write!(f, "push"),
            Self::Ebench => write!(f, "ebench"),
            Self::Flageval => write!(f, "flageval"),
        }
    }
}

impl Default for Profile {
    fn default() -> Profile {
        Self::Core
    }
}
