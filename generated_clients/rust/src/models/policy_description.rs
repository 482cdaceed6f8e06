/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// PolicyDescription : What a policy server says of itself; see policy.yaml.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct PolicyDescription {
    #[serde(rename = "name")]
    pub name: String,
    #[serde(rename = "version", skip_serializing_if = "Option::is_none")]
    pub version: Option<String>,
    #[serde(rename = "protocol")]
    pub protocol: models::ProtocolRange,
    /// Most episodes that it plays at a time.
    #[serde(rename = "max_sessions")]
    pub max_sessions: i32,
    #[serde(rename = "assumes", skip_serializing_if = "Option::is_none")]
    pub assumes: Option<Box<models::Assumptions>>,
}

impl PolicyDescription {
    /// What a policy server says of itself; see policy.yaml.
    pub fn new(name: String, protocol: models::ProtocolRange, max_sessions: i32) -> PolicyDescription {
        PolicyDescription {
            name,
            version: None,
            protocol,
            max_sessions,
            assumes: None,
        }
    }
}
