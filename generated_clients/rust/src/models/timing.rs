/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// Timing : Server time of this turn, in seconds.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct Timing {
    #[serde(rename = "total_s")]
    pub total_s: f64,
    #[serde(rename = "queue_s")]
    pub queue_s: f64,
    #[serde(rename = "simulate_s")]
    pub simulate_s: f64,
    #[serde(rename = "render_s")]
    pub render_s: f64,
    /// Encoding of images.
    #[serde(rename = "encode_s")]
    pub encode_s: f64,
}

impl Timing {
    /// Server time of this turn, in seconds.
    pub fn new(total_s: f64, queue_s: f64, simulate_s: f64, render_s: f64, encode_s: f64) -> Timing {
        Timing {
            total_s,
            queue_s,
            simulate_s,
            render_s,
            encode_s,
        }
    }
}
