/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// ImageChoice : Recorded with the result, because it changes the score.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct ImageChoice {
    #[serde(rename = "codec")]
    pub codec: String,
    #[serde(rename = "width")]
    pub width: i32,
    #[serde(rename = "height")]
    pub height: i32,
}

impl ImageChoice {
    /// Recorded with the result, because it changes the score.
    pub fn new(codec: String, width: i32, height: i32) -> ImageChoice {
        ImageChoice {
            codec,
            width,
            height,
        }
    }
}
