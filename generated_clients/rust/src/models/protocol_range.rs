/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct ProtocolRange {
    #[serde(rename = "min")]
    pub min: String,
    #[serde(rename = "max")]
    pub max: String,
}

impl ProtocolRange {
    pub fn new(min: String, max: String) -> ProtocolRange {
        ProtocolRange {
            min,
            max,
        }
    }
}
