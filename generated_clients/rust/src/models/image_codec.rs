/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

///
#[derive(Clone, Copy, Debug, Eq, PartialEq, Ord, PartialOrd, Hash, Serialize, Deserialize)]
pub enum ImageCodec {
    #[serde(rename = "raw")]
    Raw,
    #[serde(rename = "png")]
    Png,
    #[serde(rename = "jpeg")]
    Jpeg,

}

impl std::fmt::Display for ImageCodec {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            Self::Raw => write!(f, "raw"),
            Self::Png => write!(f, "png"),
            Self::Jpeg => write!(f, "jpeg"),
        }
    }
}

impl Default for ImageCodec {
    fn default() -> ImageCodec {
        Self::Raw
    }
}
