/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct Observation {
    #[serde(rename = "state")]
    pub state: std::collections::HashMap<String, Vec<f64>>,
    #[serde(rename = "images")]
    pub images: std::collections::HashMap<String, models::Image>,
    #[serde(rename = "tensors")]
    pub tensors: std::collections::HashMap<String, models::Tensor>,
}

impl Observation {
    pub fn new(state: std::collections::HashMap<String, Vec<f64>>, images: std::collections::HashMap<String, models::Image>, tensors: std::collections::HashMap<String, models::Tensor>) -> Observation {
        Observation {
            state,
            images,
            tensors,
        }
    }
}
