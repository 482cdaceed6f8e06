/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// Image : RGB or grey, row 0 on top; raw is height × width × channels bytes.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct Image {
    #[serde(rename = "codec")]
    pub codec: String,
    #[serde(rename = "width")]
    pub width: i32,
    #[serde(rename = "height")]
    pub height: i32,
    #[serde(rename = "channels")]
    pub channels: i32,
    /// Base64 with padding in JSON; `bin` in MessagePack.
    #[serde(rename = "data")]
    pub data: String,
}

impl Image {
    /// RGB or grey, row 0 on top; raw is height × width × channels bytes.
    pub fn new(codec: String, width: i32, height: i32, channels: i32, data: String) -> Image {
        Image {
            codec,
            width,
            height,
            channels,
            data,
        }
    }
}
