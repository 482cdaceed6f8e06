/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// PolicyServer : Where the server finds the policy of a run with mode `push`, and how it calls it.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct PolicyServer {
    /// Base URL, without user, query or fragment; the path of an operation is appended to it.
    #[serde(rename = "url")]
    pub url: String,
    #[serde(rename = "protocol")]
    pub protocol: models::PolicyProtocol,
    /// Sent as bearer token with every call, and never shown.
    #[serde(rename = "api_key", skip_serializing_if = "Option::is_none")]
    pub api_key: Option<String>,
    /// Which model is asked, where a protocol knows several.
    #[serde(rename = "model", skip_serializing_if = "Option::is_none")]
    pub model: Option<String>,
    /// Time for one call, from connecting to the last byte of its answer; 30 when absent.
    #[serde(rename = "call_timeout_s", skip_serializing_if = "Option::is_none")]
    pub call_timeout_s: Option<f64>,
    /// Most episodes played and calls made at a time; as many as the policy, the run and the server allow when absent.
    #[serde(rename = "max_concurrent", skip_serializing_if = "Option::is_none")]
    pub max_concurrent: Option<i32>,
    /// How often a call that was not answered is repeated; 3 when absent.
    #[serde(rename = "max_retries", skip_serializing_if = "Option::is_none")]
    pub max_retries: Option<i32>,
    /// Numbers that a chat completion is asked with, such as `temperature` and `max_tokens`; for `openai_chat` and `openai_completions` alone.
    #[serde(rename = "generation", skip_serializing_if = "Option::is_none")]
    pub generation: Option<std::collections::HashMap<String, f64>>,
}

impl PolicyServer {
    /// Where the server finds the policy of a run with mode `push`, and how it calls it.
    pub fn new(url: String, protocol: models::PolicyProtocol) -> PolicyServer {
        PolicyServer {
            url,
            protocol,
            api_key: None,
            model: None,
            call_timeout_s: None,
            max_concurrent: None,
            max_retries: None,
            generation: None,
        }
    }
}
