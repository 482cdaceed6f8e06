/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct Heartbeat {
    #[serde(rename = "session_id")]
    pub session_id: String,
}

impl Heartbeat {
    pub fn new(session_id: String) -> Heartbeat {
        Heartbeat {
            session_id,
        }
    }
}
