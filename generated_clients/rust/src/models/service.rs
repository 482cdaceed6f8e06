/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// Service : What a server says of itself before anyone authenticates.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct Service {
    #[serde(rename = "name")]
    pub name: String,
    /// Version of the server software.
    #[serde(rename = "version")]
    pub version: String,
    #[serde(rename = "protocol")]
    pub protocol: models::ProtocolRange,
    /// Parts of the protocol offered; `core` may be left out, for it always is. An operation with `x-profile` is there when its profile is announced. The rules of the profile `crash` are not announced. The kit judges them where it may kill and restart the server; a server whose runs do not outlive its process is certified without them and without EVT-009, PUSH-017, REC-123 and REC-124, and its report says that they were not verified. Those of the profile `cluster` are not announced, either. They bind a service that is reached at several base URLs, and the kit judges them where it is given all of these.
    #[serde(rename = "profiles")]
    pub profiles: Vec<String>,
    #[serde(rename = "limits")]
    pub limits: models::Limits,
    /// Media types of the data plane.
    #[serde(rename = "encodings")]
    pub encodings: Vec<String>,
    #[serde(rename = "image_codecs")]
    pub image_codecs: Vec<String>,
    /// The server's clock, UTC.
    #[serde(rename = "server_time")]
    pub server_time: chrono::DateTime<chrono::FixedOffset>,
}

impl Service {
    /// What a server says of itself before anyone authenticates.
    pub fn new(name: String, version: String, protocol: models::ProtocolRange, profiles: Vec<String>, limits: models::Limits, encodings: Vec<String>, image_codecs: Vec<String>, server_time: chrono::DateTime<chrono::FixedOffset>) -> Service {
        Service {
            name,
            version,
            protocol,
            profiles,
            limits,
            encodings,
            image_codecs,
            server_time,
        }
    }
}
