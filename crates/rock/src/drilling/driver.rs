//! Drive of a bit on its own.

use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

use super::{Advance, BitMotion, Drilling, Inertia};
use crate::{executor::Executor, kernel::Stepper};

/// A bit without a string: held to the hole's axis and turned at a constant speed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Driver {
    /// A constant weight on bit.
    Weight {
        /// The weight, N.
        weight_N: f64,
        /// Mass that moves along the hole with the bit, kg. It must be well above that of the nodes
        /// that the bit touches.
        mass_kg: f64,
        /// Rotary speed, rad/s.
        rotary_rad_per_s: f64,
    },
    /// A constant rate of penetration.
    Rate {
        /// The rate, m/s.
        rate_m_per_s: f64,
        /// Rotary speed, rad/s.
        rotary_rad_per_s: f64,
    },
}

impl Driver {
    /// Motion of the bit.
    pub fn motion(&self, drilling: &Drilling) -> BitMotion {
        let (rate, weight_N, mass_kg, rotary) = match *self {
            Self::Weight { weight_N, mass_kg, rotary_rad_per_s } => {
                let rate = drilling.pose().velocity_m_per_s.z;
                (rate, weight_N, mass_kg, rotary_rad_per_s)
            }
            Self::Rate { rate_m_per_s, rotary_rad_per_s } => {
                (rate_m_per_s, 0.0, f64::INFINITY, rotary_rad_per_s)
            }
        };
        BitMotion {
            velocity_m_per_s: Vector3::z() * rate,
            angular_velocity_rad_per_s: Vector3::z() * rotary,
            force_N: Vector3::z() * weight_N,
            moment_N_m: Vector3::zeros(),
            inertia: Inertia { mass_kg, ..Inertia::PRESCRIBED },
        }
    }

    /// Drills on for a time.
    pub fn drive(
        &self,
        drilling: &mut Drilling,
        time_s: f64,
        stepper: &Stepper,
        executor: &impl Executor,
    ) -> Advance {
        let motion = self.motion(drilling);
        drilling.advance(time_s, &motion, stepper, executor)
    }
}
