/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// PolicyProtocol : `proctor` is policy.yaml. `openai_chat` asks for a chat completion at `chat/completions` below the URL, for benchmarks that are answered in words. `openai_completions` asks for the completion of a text at `completions` below the URL, for such benchmarks without images.
/// `proctor` is policy.yaml. `openai_chat` asks for a chat completion at `chat/completions` below the URL, for benchmarks that are answered in words. `openai_completions` asks for the completion of a text at `completions` below the URL, for such benchmarks without images.
#[derive(Clone, Copy, Debug, Eq, PartialEq, Ord, PartialOrd, Hash, Serialize, Deserialize)]
pub enum PolicyProtocol {
    #[serde(rename = "proctor")]
    Proctor,
    #[serde(rename = "openai_chat")]
    OpenaiChat,
    #[serde(rename = "openai_completions")]
    OpenaiCompletions,

}

impl std::fmt::Display for PolicyProtocol {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            Self::Proctor => write!(f, "proctor"),
            Self::OpenaiChat => write!(f, "openai_chat"),
            Self::OpenaiCompletions => write!(f, "openai_completions"),
        }
    }
}

impl Default for PolicyProtocol {
    fn default() -> PolicyProtocol {
        Self::Proctor
    }
}
