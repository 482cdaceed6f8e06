/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// Benchmark : Everything about a benchmark that can change a score.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct Benchmark {
    #[serde(rename = "benchmark_id")]
    pub benchmark_id: String,
    #[serde(rename = "version")]
    pub version: String,
    #[serde(rename = "title")]
    pub title: String,
    #[serde(rename = "description")]
    pub description: String,
    /// The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
    #[serde(rename = "manifest_sha256")]
    pub manifest_sha256: String,
    #[serde(rename = "episodes_total")]
    pub episodes_total: i32,
    #[serde(rename = "tasks")]
    pub tasks: Vec<String>,
    #[serde(rename = "splits")]
    pub splits: Vec<String>,
    /// Splits whose seeds the host draws in secret; none when absent.
    #[serde(rename = "sealed_splits", skip_serializing_if = "Option::is_none")]
    pub sealed_splits: Option<Vec<String>>,
    /// What the host commits itself to without showing it, the SHA-256 of a secret salt and the sealed seeds. With both disclosed later, anyone can prove which seeds were played.
    #[serde(rename = "seeds_sha256", skip_serializing_if = "Option::is_none")]
    pub seeds_sha256: Option<String>,
    /// Actions per simulated second.
    #[serde(rename = "control_rate_hz")]
    pub control_rate_hz: f64,
    /// Steps after which an episode is truncated.
    #[serde(rename = "max_steps")]
    pub max_steps: i32,
    #[serde(rename = "max_chunk")]
    pub max_chunk: i32,
    #[serde(rename = "max_attempts")]
    pub max_attempts: i32,
    #[serde(rename = "max_faults")]
    pub max_faults: i32,
    /// A `SuccessRule`, or one of a later version.
    #[serde(rename = "success_rule")]
    pub success_rule: String,
    /// Name of an action value → what it means.
    #[serde(rename = "action_space")]
    pub action_space: std::collections::HashMap<String, models::VectorSpace>,
    #[serde(rename = "observation_space")]
    pub observation_space: models::ObservationSpace,
    /// Sizes that may be chosen at submit; the first is the default.
    #[serde(rename = "image_sizes")]
    pub image_sizes: Vec<models::ImageSize>,
    /// Codecs that may be chosen at submit; the first is the default.
    #[serde(rename = "image_codecs")]
    pub image_codecs: Vec<String>,
    #[serde(rename = "simulator")]
    pub simulator: models::SimulatorInfo,
    /// Why a run cannot be submitted here now, and the cure; null when it can.
    #[serde(rename = "unavailable_reason", deserialize_with = "Option::deserialize")]
    pub unavailable_reason: Option<String>,
}

impl Benchmark {
    /// Everything about a benchmark that can change a score.
    pub fn new(benchmark_id: String, version: String, title: String, description: String, manifest_sha256: String, episodes_total: i32, tasks: Vec<String>, splits: Vec<String>, control_rate_hz: f64, max_steps: i32, max_chunk: i32, max_attempts: i32, max_faults: i32, success_rule: String, action_space: std::collections::HashMap<String, models::VectorSpace>, observation_space: models::ObservationSpace, image_sizes: Vec<models::ImageSize>, image_codecs: Vec<String>, simulator: models::SimulatorInfo, unavailable_reason: Option<String>) -> Benchmark {
        Benchmark {
            benchmark_id,
            version,
            title,
            description,
            manifest_sha256,
            episodes_total,
            tasks,
            splits,
            sealed_splits: None,
            seeds_sha256: None,
            control_rate_hz,
            max_steps,
            max_chunk,
            max_attempts,
            max_faults,
            success_rule,
            action_space,
            observation_space,
            image_sizes,
            image_codecs,
            simulator,
            unavailable_reason,
        }
    }
}
