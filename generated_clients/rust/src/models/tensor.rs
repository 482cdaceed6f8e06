/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// Tensor : C order, little-endian; a bool is one byte, 0 or 1.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct Tensor {
    #[serde(rename = "dtype")]
    pub dtype: String,
    #[serde(rename = "shape")]
    pub shape: Vec<i64>,
    /// Base64 with padding in JSON; `bin` in MessagePack.
    #[serde(rename = "data")]
    pub data: String,
}

impl Tensor {
    /// C order, little-endian; a bool is one byte, 0 or 1.
    pub fn new(dtype: String, shape: Vec<i64>, data: String) -> Tensor {
        Tensor {
            dtype,
            shape,
            data,
        }
    }
}
