/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// Fault : The simulator broke; the episode began again, at no cost to the policy. Nothing of the chunk counts as executed. A turn that ends an episode has its result instead, and `list_episodes` the faults of the next one.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct Fault {
    #[serde(rename = "episode_id")]
    pub episode_id: String,
    /// Faults of this episode so far.
    #[serde(rename = "faults")]
    pub faults: i32,
    #[serde(rename = "detail")]
    pub detail: String,
}

impl Fault {
    /// The simulator broke; the episode began again, at no cost to the policy. Nothing of the chunk counts as executed. A turn that ends an episode has its result instead, and `list_episodes` the faults of the next one.
    pub fn new(episode_id: String, faults: i32, detail: String) -> Fault {
        Fault {
            episode_id,
            faults,
            detail,
        }
    }
}
