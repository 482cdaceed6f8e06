/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct ProblemItem {
    /// JSON pointer into the body, to the faulty member or a part of it; or `query:name`, `header:name`, `path:name`; or `record:name`, with the name of a file in a record.
    #[serde(rename = "pointer")]
    pub pointer: String,
    #[serde(rename = "detail")]
    pub detail: String,
}

impl ProblemItem {
    pub fn new(pointer: String, detail: String) -> ProblemItem {
        ProblemItem {
            pointer,
            detail,
        }
    }
}
