/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct TensorSpace {
    #[serde(rename = "dtype")]
    pub dtype: String,
    #[serde(rename = "shape")]
    pub shape: Vec<i32>,
    #[serde(rename = "description")]
    pub description: String,
    #[serde(rename = "tasks", skip_serializing_if = "Option::is_none")]
    pub tasks: Option<Vec<String>>,
}

impl TensorSpace {
    pub fn new(dtype: String, shape: Vec<i32>, description: String) -> TensorSpace {
        TensorSpace {
            dtype,
            shape,
            description,
            tasks: None,
        }
    }
}
