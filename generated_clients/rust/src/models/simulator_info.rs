/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct SimulatorInfo {
    #[serde(rename = "name")]
    pub name: String,
    #[serde(rename = "version")]
    pub version: String,
    /// Named rendering quality, where there is one.
    #[serde(rename = "quality", skip_serializing_if = "Option::is_none")]
    pub quality: Option<String>,
}

impl SimulatorInfo {
    pub fn new(name: String, version: String) -> SimulatorInfo {
        SimulatorInfo {
            name,
            version,
            quality: None,
        }
    }
}
