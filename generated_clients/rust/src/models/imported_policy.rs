/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct ImportedPolicy {
    #[serde(rename = "name")]
    pub name: String,
    #[serde(rename = "version", deserialize_with = "Option::deserialize")]
    pub version: Option<String>,
}

impl ImportedPolicy {
    pub fn new(name: String, version: Option<String>) -> ImportedPolicy {
        ImportedPolicy {
            name,
            version,
        }
    }
}
