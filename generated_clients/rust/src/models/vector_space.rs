/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

/// VectorSpace : One named vector of numbers, with every convention a policy could get wrong.
#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct VectorSpace {
    #[serde(rename = "size")]
    pub size: i32,
    /// `rad`, `m`, `1`, or several joined by commas.
    #[serde(rename = "unit")]
    pub unit: String,
    #[serde(rename = "rotation")]
    pub rotation: String,
    /// `world`, `base`, `tool`, `joint`, or `none`.
    #[serde(rename = "frame")]
    pub frame: String,
    /// True when the values are increments.
    #[serde(rename = "relative")]
    pub relative: bool,
    /// The value that means fully open.
    #[serde(rename = "gripper_open", skip_serializing_if = "Option::is_none")]
    pub gripper_open: Option<f64>,
    #[serde(rename = "minimum", skip_serializing_if = "Option::is_none")]
    pub minimum: Option<Vec<f64>>,
    #[serde(rename = "maximum", skip_serializing_if = "Option::is_none")]
    pub maximum: Option<Vec<f64>>,
    #[serde(rename = "out_of_range")]
    pub out_of_range: String,
    /// What the numbers are.
    #[serde(rename = "description", skip_serializing_if = "Option::is_none")]
    pub description: Option<String>,
    /// The tasks that have this entry; all of them when absent.
    #[serde(rename = "tasks", skip_serializing_if = "Option::is_none")]
    pub tasks: Option<Vec<String>>,
}

impl VectorSpace {
    /// One named vector of numbers, with every convention a policy could get wrong.
    pub fn new(size: i32, unit: String, rotation: String, frame: String, relative: bool, out_of_range: String) -> VectorSpace {
        VectorSpace {
            size,
            unit,
            rotation,
            frame,
            relative,
            gripper_open: None,
            minimum: None,
            maximum: None,
            out_of_range,
            description: None,
            tasks: None,
        }
    }
}
