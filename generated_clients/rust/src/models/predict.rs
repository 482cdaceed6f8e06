/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct Predict {
    #[serde(rename = "session_id")]
    pub session_id: String,
    #[serde(rename = "seq")]
    pub seq: i64,
    #[serde(rename = "actions")]
    pub actions: Vec<models::Action>,
    #[serde(rename = "observe", skip_serializing_if = "Option::is_none")]
    pub observe: Option<models::Observe>,
}

impl Predict {
    pub fn new(session_id: String, seq: i64, actions: Vec<models::Action>) -> Predict {
        Predict {
            session_id,
            seq,
            actions,
            observe: None,
        }
    }
}
