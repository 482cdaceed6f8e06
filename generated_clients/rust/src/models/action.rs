/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct Action {
    /// Name → vector, exactly the entries of the benchmark's action space.
    #[serde(rename = "values")]
    pub values: std::collections::HashMap<String, Vec<f64>>,
}

impl Action {
    pub fn new(values: std::collections::HashMap<String, Vec<f64>>) -> Action {
        Action {
            values,
        }
    }
}
