/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// SelectionView : The `select` of a run, as it was submitted.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct SelectionView {
    #[serde(rename = "tasks", skip_serializing_if = "Option::is_none")]
    pub tasks: Option<Vec<String>>,
    #[serde(rename = "splits", skip_serializing_if = "Option::is_none")]
    pub splits: Option<Vec<String>>,
}

impl SelectionView {
    /// The `select` of a run, as it was submitted.
    pub fn new() -> SelectionView {
        SelectionView {
            tasks: None,
            splits: None,
        }
    }
}
