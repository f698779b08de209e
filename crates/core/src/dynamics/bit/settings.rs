//! Which law the bit follows, and its numbers.

use serde::{Deserialize, Serialize};

use super::{Excitation, RegenerativeLaw};

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

/// How the rock answers a bit.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum BitLaw {
    /// The operation's rate of penetration in proportion to weight and speed; torque in proportion to
    /// weight.
    Rate(RateLaw),
    /// Weight and torque from the depth of cut, which the bit's own passage before has left.
    Regenerative(RegenerativeLaw),
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
