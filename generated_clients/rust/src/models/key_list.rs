/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct KeyList {
    #[serde(rename = "keys")]
    pub keys: Vec<models::PublicKey>,
}

impl KeyList {
    pub fn new(keys: Vec<models::PublicKey>) -> KeyList {
        KeyList {
            keys,
        }
    }
}
