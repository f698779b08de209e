//! What an equilibrium tells of itself and of its bit, for whoever writes it down.

use serde::{Deserialize, Serialize};

use super::{equilibrium::Convergence, profile::StiffProfile};
use crate::finite;

/// How an equilibrium was found, how sound it is, and what its bit does to the rock.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct EquilibriumSummary {
    /// How it was found.
    #[serde(flatten)]
    pub convergence: Convergence,
    /// Side force of the bit on the rock towards the high side, N: what builds.
    #[serde(with = "finite")]
    pub bit_side_force_high_N: f64,
    /// To the right of it as one looks down the hole, N.
    #[serde(with = "finite")]
    pub bit_side_force_right_N: f64,
    /// Tilt of the bit against the hole's axis towards the high side, rad.
    #[serde(with = "finite")]
    pub bit_tilt_high_rad: f64,
    /// To the right of it, rad.
    #[serde(with = "finite")]
    pub bit_tilt_right_rad: f64,
}

impl From<&StiffProfile> for EquilibriumSummary {
    fn from(of: &StiffProfile) -> Self {
        let [bit_side_force_high_N, bit_side_force_right_N] = of.bit_side_force_N;
        let [bit_tilt_high_rad, bit_tilt_right_rad] = of.bit_tilt_rad;
        Self {
            convergence: of.convergence,
            bit_side_force_high_N,
            bit_side_force_right_N,
            bit_tilt_high_rad,
            bit_tilt_right_rad,
        }
    }
}
