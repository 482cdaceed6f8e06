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

}

impl std::fmt::Display for Profile {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            Self::Core => write!(f, "core"),
            Self::Msgpack => write!(f, "msgpack"),
        }
    }
}

impl Default for Profile {
    fn default() -> Profile {
        Self::Core
    }
}
