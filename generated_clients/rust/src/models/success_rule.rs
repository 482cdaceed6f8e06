/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

///
#[derive(Clone, Copy, Debug, Eq, PartialEq, Ord, PartialOrd, Hash, Serialize, Deserialize)]
pub enum SuccessRule {
    #[serde(rename = "any_step")]
    AnyStep,
    #[serde(rename = "last_step")]
    LastStep,

}

impl std::fmt::Display for SuccessRule {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            Self::AnyStep => write!(f, "any_step"),
            Self::LastStep => write!(f, "last_step"),
        }
    }
}

impl Default for SuccessRule {
    fn default() -> SuccessRule {
        Self::AnyStep
    }
}
