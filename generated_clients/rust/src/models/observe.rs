/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// Observe : `last` when absent; `all` adds the observation after every executed action.
/// `last` when absent; `all` adds the observation after every executed action.
#[derive(Clone, Copy, Debug, Eq, PartialEq, Ord, PartialOrd, Hash, Serialize, Deserialize)]
pub enum Observe {
    #[serde(rename = "last")]
    Last,
    #[serde(rename = "all")]
    All,

}

impl std::fmt::Display for Observe {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            Self::Last => write!(f, "last"),
            Self::All => write!(f, "all"),
        }
    }
}

impl Default for Observe {
    fn default() -> Observe {
        Self::Last
    }
}
