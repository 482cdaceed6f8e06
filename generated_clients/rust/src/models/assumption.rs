/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

#[derive(Clone, Default, Debug, PartialEq, Serialize, Deserialize)]
pub struct Assumption {
    #[serde(rename = "size", skip_serializing_if = "Option::is_none")]
    pub size: Option<i32>,
    #[serde(rename = "unit", skip_serializing_if = "Option::is_none")]
    pub unit: Option<String>,
    #[serde(rename = "rotation", skip_serializing_if = "Option::is_none")]
    pub rotation: Option<String>,
    #[serde(rename = "frame", skip_serializing_if = "Option::is_none")]
    pub frame: Option<String>,
    #[serde(rename = "relative", skip_serializing_if = "Option::is_none")]
    pub relative: Option<bool>,
    #[serde(rename = "gripper_open", skip_serializing_if = "Option::is_none")]
    pub gripper_open: Option<f64>,
}

impl Assumption {
    pub fn new() -> Assumption {
        Assumption {
            size: None,
            unit: None,
            rotation: None,
            frame: None,
            relative: None,
            gripper_open: None,
        }
    }
}
