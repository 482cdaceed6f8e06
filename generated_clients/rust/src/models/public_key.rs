/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct PublicKey {
    /// `SHA256:` and the SHA-256 of the key in hexadecimal digits.
    #[serde(rename = "keyid")]
    pub keyid: String,
    /// `ed25519`, or another one of a later version.
    #[serde(rename = "algorithm")]
    pub algorithm: String,
    /// Its 32 bytes.
    #[serde(rename = "public_key")]
    pub public_key: String,
    #[serde(rename = "created_at")]
    pub created_at: chrono::DateTime<chrono::FixedOffset>,
    /// When it signed for the last time; null for the key in use.
    #[serde(rename = "retired_at", deserialize_with = "Option::deserialize")]
    pub retired_at: Option<chrono::DateTime<chrono::FixedOffset>>,
}

impl PublicKey {
    pub fn new(keyid: String, algorithm: String, public_key: String, created_at: chrono::DateTime<chrono::FixedOffset>, retired_at: Option<chrono::DateTime<chrono::FixedOffset>>) -> PublicKey {
        PublicKey {
            keyid,
            algorithm,
            public_key,
            created_at,
            retired_at,
        }
    }
}
