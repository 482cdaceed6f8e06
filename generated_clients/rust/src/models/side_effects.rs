/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

///
#[derive(Clone, Copy, Debug, Eq, PartialEq, Ord, PartialOrd, Hash, Serialize, Deserialize)]
pub enum SideEffects {
    #[serde(rename = "none")]
    None,
    #[serde(rename = "possible")]
    Possible,

}

impl std::fmt::Display for SideEffects {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            Self::None => write!(f, "none"),
            Self::Possible => write!(f, "possible"),
        }
    }
}

impl Default for SideEffects {
    fn default() -> SideEffects {
        Self::None
    }
}
