/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct AttachWorker {
    /// New for every attachment; repeated only to repeat a lost request.
    #[serde(rename = "attach_key")]
    pub attach_key: String,
    /// Fence out a live session; false when absent.
    #[serde(rename = "takeover", skip_serializing_if = "Option::is_none")]
    pub takeover: Option<bool>,
    #[serde(rename = "assumes", skip_serializing_if = "Option::is_none")]
    pub assumes: Option<Box<models::Assumptions>>,
    #[serde(rename = "player", skip_serializing_if = "Option::is_none")]
    pub player: Option<Box<models::Player>>,
}

impl AttachWorker {
    pub fn new(attach_key: String) -> AttachWorker {
        AttachWorker {
            attach_key,
            takeover: None,
            assumes: None,
            player: None,
        }
    }
}
