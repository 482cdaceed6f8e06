/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct ObservationSpace {
    #[serde(rename = "state")]
    pub state: std::collections::HashMap<String, models::VectorSpace>,
    #[serde(rename = "images")]
    pub images: std::collections::HashMap<String, models::ImageSpace>,
    #[serde(rename = "tensors")]
    pub tensors: std::collections::HashMap<String, models::TensorSpace>,
}

impl ObservationSpace {
    pub fn new(state: std::collections::HashMap<String, models::VectorSpace>, images: std::collections::HashMap<String, models::ImageSpace>, tensors: std::collections::HashMap<String, models::TensorSpace>) -> ObservationSpace {
        ObservationSpace {
            state,
            images,
            tensors,
        }
    }
}
