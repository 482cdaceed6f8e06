/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct EpisodeList {
    #[serde(rename = "episodes")]
    pub episodes: Vec<models::Episode>,
    #[serde(rename = "next_cursor", deserialize_with = "Option::deserialize")]
    pub next_cursor: Option<String>,
}

impl EpisodeList {
    pub fn new(episodes: Vec<models::Episode>, next_cursor: Option<String>) -> EpisodeList {
        EpisodeList {
            episodes,
            next_cursor,
        }
    }
}
