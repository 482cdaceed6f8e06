/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

use crate::models;
use serde::{Deserialize, Serialize};

///
#[derive(Clone, Copy, Debug, Eq, PartialEq, Ord, PartialOrd, Hash, Serialize, Deserialize)]
pub enum Rotation {
    #[serde(rename = "none")]
    None,
    #[serde(rename = "quaternion_wxyz")]
    QuaternionWxyz,
    #[serde(rename = "quaternion_xyzw")]
    QuaternionXyzw,
    #[serde(rename = "axis_angle")]
    AxisAngle,
    #[serde(rename = "euler_xyz")]
    EulerXyz,
    #[serde(rename = "rot6d_columns")]
    Rot6dColumns,

}

impl std::fmt::Display for Rotation {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            Self::None => write!(f, "none"),
            Self::QuaternionWxyz => write!(f, "quaternion_wxyz"),
            Self::QuaternionXyzw => write!(f, "quaternion_xyzw"),
            Self::AxisAngle => write!(f, "axis_angle"),
            Self::EulerXyz => write!(f, "euler_xyz"),
            Self::Rot6dColumns => write!(f, "rot6d_columns"),
        }
    }
}

impl Default for Rotation {
    fn default() -> Rotation {
        Self::None
    }
}
