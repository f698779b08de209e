//! Summary of an equilibrium and of its bit.

use serde::{Deserialize, Serialize};

use super::{equilibrium::Convergence, profile::StiffProfile};
use crate::finite;

/// Convergence and validity of an equilibrium, and the loads of its bit on the rock.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct EquilibriumSummary {
    /// Convergence of its solution.
    #[serde(flatten)]
    pub convergence: Convergence,
    /// Side force of the bit on the rock towards the high side, N: it builds inclination.
    #[serde(with = "finite")]
    pub bit_side_force_high_N: f64,
    /// To the right of it, looking down the hole, N.
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
    fn from(profile: &StiffProfile) -> Self {
        let [bit_side_force_high_N, bit_side_force_right_N] = profile.bit_side_force_N;
        let [bit_tilt_high_rad, bit_tilt_right_rad] = profile.bit_tilt_rad;
        Self {
            convergence: profile.convergence,
            bit_side_force_high_N,
            bit_side_force_right_N,
            bit_tilt_high_rad,
            bit_tilt_right_rad,
        }
    }
}
