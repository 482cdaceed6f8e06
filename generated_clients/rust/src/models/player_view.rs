/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// PlayerView : The `player` of an `attach_worker`.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct PlayerView {
    #[serde(rename = "name")]
    pub name: String,
    #[serde(rename = "version", skip_serializing_if = "Option::is_none")]
    pub version: Option<String>,
    #[serde(rename = "client", skip_serializing_if = "Option::is_none")]
    pub client: Option<String>,
}

impl PlayerView {
    /// The `player` of an `attach_worker`.
    pub fn new(name: String) -> PlayerView {
        PlayerView {
            name,
            version: None,
            client: None,
        }
    }
}
