/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct ImageSpace {
    #[serde(rename = "channels")]
    pub channels: i32,
    #[serde(rename = "description")]
    pub description: String,
    #[serde(rename = "tasks", skip_serializing_if = "Option::is_none")]
    pub tasks: Option<Vec<String>>,
}

impl ImageSpace {
    pub fn new(channels: i32, description: String) -> ImageSpace {
        ImageSpace {
            channels,
            description,
            tasks: None,
        }
    }
}
