/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct RunList {
    #[serde(rename = "runs")]
    pub runs: Vec<models::Run>,
    #[serde(rename = "next_cursor", deserialize_with = "Option::deserialize")]
    pub next_cursor: Option<String>,
}

impl RunList {
    pub fn new(runs: Vec<models::Run>, next_cursor: Option<String>) -> RunList {
        RunList {
            runs,
            next_cursor,
        }
    }
}
