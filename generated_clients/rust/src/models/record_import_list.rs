/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct RecordImportList {
    #[serde(rename = "imports")]
    pub imports: Vec<models::RecordImport>,
    #[serde(rename = "next_cursor", deserialize_with = "Option::deserialize")]
    pub next_cursor: Option<String>,
}

impl RecordImportList {
    pub fn new(imports: Vec<models::RecordImport>, next_cursor: Option<String>) -> RecordImportList {
        RecordImportList {
            imports,
            next_cursor,
        }
    }
}
