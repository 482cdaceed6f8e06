/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct Lease {
    #[serde(rename = "expires_at")]
    pub expires_at: chrono::DateTime<chrono::FixedOffset>,
    #[serde(rename = "idle_timeout_s")]
    pub idle_timeout_s: f64,
}

impl Lease {
    pub fn new(expires_at: chrono::DateTime<chrono::FixedOffset>, idle_timeout_s: f64) -> Lease {
        Lease {
            expires_at,
            idle_timeout_s,
        }
    }
}
