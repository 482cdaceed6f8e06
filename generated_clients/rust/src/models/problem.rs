/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// Problem : RFC 9457, with what a client needs to decide on a retry.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct Problem {
    #[serde(rename = "type")]
    pub r#type: String,
    #[serde(rename = "title")]
    pub title: String,
    #[serde(rename = "status")]
    pub status: i32,
    /// What happened and what to do about it.
    #[serde(rename = "detail")]
    pub detail: String,
    /// One of x-problems, or one of a later version.
    #[serde(rename = "code")]
    pub code: String,
    /// Whether the same request can succeed later.
    #[serde(rename = "retryable")]
    pub retryable: bool,
    #[serde(rename = "side_effects")]
    pub side_effects: models::SideEffects,
    #[serde(rename = "errors", skip_serializing_if = "Option::is_none")]
    pub errors: Option<Vec<models::ProblemItem>>,
    /// Id of the rule that was enforced.
    #[serde(rename = "requirement", skip_serializing_if = "Option::is_none")]
    pub requirement: Option<String>,
    #[serde(rename = "state", skip_serializing_if = "Option::is_none")]
    pub state: Option<models::RunState>,
    #[serde(rename = "expected_seq", skip_serializing_if = "Option::is_none")]
    pub expected_seq: Option<i64>,
    /// What ended the session, as far as the server still knows; `unknown` after a restart, and for a session that was taken over and whose successor has ended.
    #[serde(rename = "ended_by", skip_serializing_if = "Option::is_none")]
    pub ended_by: Option<String>,
}

impl Problem {
    /// RFC 9457, with what a client needs to decide on a retry.
    pub fn new(r#type: String, title: String, status: i32, detail: String, code: String, retryable: bool, side_effects: models::SideEffects) -> Problem {
        Problem {
            r#type,
            title,
            status,
            detail,
            code,
            retryable,
            side_effects,
            errors: None,
            requirement: None,
            state: None,
            expected_seq: None,
            ended_by: None,
        }
    }
}
