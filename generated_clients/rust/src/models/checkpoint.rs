/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct Checkpoint {
    #[serde(rename = "tree_size")]
    pub tree_size: i64,
    /// The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
    #[serde(rename = "root_sha256")]
    pub root_sha256: String,
    /// The signed note, which says both as well.
    #[serde(rename = "note")]
    pub note: String,
    /// Of the key of `list_keys` that signed it.
    #[serde(rename = "keyid")]
    pub keyid: String,
}

impl Checkpoint {
    pub fn new(tree_size: i64, root_sha256: String, note: String, keyid: String) -> Checkpoint {
        Checkpoint {
            tree_size,
            root_sha256,
            note,
            keyid,
        }
    }
}
