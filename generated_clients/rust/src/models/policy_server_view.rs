/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// PolicyServerView : The policy server of a run with mode `push`, with what was left open filled in, and without its key.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct PolicyServerView {
    #[serde(rename = "url")]
    pub url: String,
    /// A `PolicyProtocol`, or one of a later version.
    #[serde(rename = "protocol")]
    pub protocol: String,
    #[serde(rename = "has_api_key")]
    pub has_api_key: bool,
    #[serde(rename = "model", skip_serializing_if = "Option::is_none")]
    pub model: Option<String>,
    #[serde(rename = "call_timeout_s")]
    pub call_timeout_s: f64,
    #[serde(rename = "max_concurrent")]
    pub max_concurrent: i32,
    #[serde(rename = "max_retries")]
    pub max_retries: i32,
    #[serde(rename = "generation", skip_serializing_if = "Option::is_none")]
    pub generation: Option<std::collections::HashMap<String, f64>>,
}

impl PolicyServerView {
    /// The policy server of a run with mode `push`, with what was left open filled in, and without its key.
    pub fn new(url: String, protocol: String, has_api_key: bool, call_timeout_s: f64, max_concurrent: i32, max_retries: i32) -> PolicyServerView {
        PolicyServerView {
            url,
            protocol,
            has_api_key,
            model: None,
            call_timeout_s,
            max_concurrent,
            max_retries,
            generation: None,
        }
    }
}
