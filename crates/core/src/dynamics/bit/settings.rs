//! Which law the bit follows, and its numbers.

use serde::{Deserialize, Serialize};

use super::{Excitation, RegenerativeLaw};
use crate::operation::Operation;

/// The bit on the rock.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct BitSettings {
    /// How the rock answers.
    pub law: BitLaw,
    /// Lateral stiffness that holds the bit to the hole's axis, N/m.
    pub lateral_stiffness_N_per_m: f64,
    /// Speed at which a mud motor turns the bit against the string, rad/s; zero without one.
    pub motor_speed_rad_per_s: f64,
}

impl Default for BitSettings {
    /// The rate law on rock of 1e8 N/m without excitation, 1e7 N/m across, no motor.
    fn default() -> Self {
        Self {
            law: BitLaw::Rate(RateLaw {
                rock_stiffness_N_per_m: 1e8,
                excitation: None,
            }),
            lateral_stiffness_N_per_m: 1e7,
            motor_speed_rad_per_s: 0.0,
        }
    }
}

impl BitSettings {
    /// Whether the speed of a sliding string's motor makes a difference: where the bit's angle counts.
    pub fn asks_for_motor_speed(&self) -> bool {
        match self.law {
            BitLaw::Rate(law) => law.excitation.is_some(),
            BitLaw::Regenerative(_) => true,
        }
    }

    /// The operation with the torque and the rate of penetration of steady drilling, where the law knows
    /// them: the regenerative law finds them from weight and speed, the rate law takes the operation's.
    #[must_use]
    pub fn drilling_steadily(&self, operation: Operation) -> Operation {
        let BitLaw::Regenerative(law) = self.law else {
            return operation;
        };
        let speed = operation.rotation_rad_per_s() + self.motor_speed_rad_per_s;
        let steady = law.steady(operation.weight_on_bit_N, speed);
        Operation {
            bit_torque_N_m: steady.torque_N_m,
            rate_of_penetration_m_per_s: steady.rate_of_penetration_m_per_s,
            ..operation
        }
    }
}

/// How the rock answers a bit.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum BitLaw {
    /// The operation's rate of penetration in proportion to weight and speed; torque in proportion to
    /// weight.
    Rate(RateLaw),
    /// Weight and torque from the depth of cut, which the bit's own passage before has left.
    Regenerative(RegenerativeLaw),
}

impl BitLaw {
    /// Stiffness of the rock under the bit, N/m.
    pub fn stiffness_N_per_m(&self) -> f64 {
        match self {
            Self::Rate(law) => law.rock_stiffness_N_per_m,
            Self::Regenerative(law) => law.stiffness_N_per_m(),
        }
    }
}

/// The rate law: on rock that lies where the bit has cut to, pressed with the force `W`, the bit advances
/// at the rate `v = v₀ (W/W₀)(Ω/Ω₀)`, its torque is `T₀ W/W₀`; `v₀`, `W₀`, `Ω₀`, `T₀` are the operation's.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct RateLaw {
    /// Stiffness of the contact between bit and rock front, N/m.
    pub rock_stiffness_N_per_m: f64,
    /// What shakes the bit; `None` for a smooth bottom.
    pub excitation: Option<Excitation>,
}
