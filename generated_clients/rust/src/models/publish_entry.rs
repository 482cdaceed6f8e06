/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// PublishEntry : What an entry says of itself; a member that is absent is not shown.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct PublishEntry {
    #[serde(rename = "model_name")]
    pub model_name: String,
    /// Whether others see the entry, and whether it has a rank.
    #[serde(rename = "is_public")]
    pub is_public: bool,
    /// What kind of model it is, for example `VLA` or `diffusion policy`.
    #[serde(rename = "model_type", skip_serializing_if = "Option::is_none")]
    pub model_type: Option<String>,
    #[serde(rename = "organisation", skip_serializing_if = "Option::is_none")]
    pub organisation: Option<String>,
    #[serde(rename = "homepage", skip_serializing_if = "Option::is_none")]
    pub homepage: Option<String>,
    #[serde(rename = "code_url", skip_serializing_if = "Option::is_none")]
    pub code_url: Option<String>,
    #[serde(rename = "notes", skip_serializing_if = "Option::is_none")]
    pub notes: Option<String>,
}

impl PublishEntry {
    /// What an entry says of itself; a member that is absent is not shown.
    pub fn new(model_name: String, is_public: bool) -> PublishEntry {
        PublishEntry {
            model_name,
            is_public,
            model_type: None,
            organisation: None,
            homepage: None,
            code_url: None,
            notes: None,
        }
    }
}
