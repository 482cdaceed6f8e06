/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// Player : Who plays, by its own words; for the profile `attribution`.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct Player {
    /// Of the policy, as in `policy` of the run.
    #[serde(rename = "name")]
    pub name: String,
    /// Of the policy.
    #[serde(rename = "version", skip_serializing_if = "Option::is_none")]
    pub version: Option<String>,
    /// The program that attaches and its version.
    #[serde(rename = "client", skip_serializing_if = "Option::is_none")]
    pub client: Option<String>,
}

impl Player {
    /// Who plays, by its own words; for the profile `attribution`.
    pub fn new(name: String) -> Player {
        Player {
            name,
            version: None,
            client: None,
        }
    }
}
