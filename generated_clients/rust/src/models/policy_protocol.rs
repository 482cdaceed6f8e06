/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// PolicyProtocol : `proctor` is policy.yaml. `openai_chat` asks for a chat completion at `chat/completions` below the URL, for benchmarks that are answered in words.
/// `proctor` is policy.yaml. `openai_chat` asks for a chat completion at `chat/completions` below the URL, for benchmarks that are answered in words.
#[derive(Clone, Copy, Debug, Eq, PartialEq, Ord, PartialOrd, Hash, Serialize, Deserialize)]
pub enum PolicyProtocol {
    #[serde(rename = "proctor")]
    Proctor,
    #[serde(rename = "openai_chat")]
    OpenaiChat,

}

impl std::fmt::Display for PolicyProtocol {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            Self::Proctor => write!(f, "proctor"),
            Self::OpenaiChat => write!(f, "openai_chat"),
        }
    }
}

impl Default for PolicyProtocol {
    fn default() -> PolicyProtocol {
        Self::Proctor
    }
}
