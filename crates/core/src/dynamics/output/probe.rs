//! Quantities of single nodes against time.

use serde::{Deserialize, Serialize};

use crate::named::named;

named! {
    /// A quantity of a node against time, read at the end of each sample but for the contact force.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
    pub enum NodeSignal {
        /// Effective tension.
        Tension = "tension",
        /// Torque.
        Torque = "torque",
        /// Bending moment, whatever its direction.
        BendingMoment = "bending_moment",
        /// Von Mises stress.
        VonMisesStress = "von_mises_stress",
        /// Contact force, averaged over the sample; positive on the high side.
        ContactForce = "contact_force",
        /// Offset from the hole's axis towards the high side.
        OffsetHigh = "offset_high",
        /// Offset to the right of it.
        OffsetRight = "offset_right",
        /// Velocity towards the high side.
        VelocityHigh = "velocity_high",
        /// Velocity to the right of it.
        VelocityRight = "velocity_right",
        /// Velocity down the hole.
        AxialVelocity = "axial_velocity",
        /// Rotary speed.
        RotarySpeed = "rotary_speed",
    }
}

impl NodeSignal {
    /// Symbol of its unit.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Tension | Self::ContactForce => "N",
            Self::Torque | Self::BendingMoment => "N·m",
            Self::VonMisesStress => "Pa",
            Self::OffsetHigh | Self::OffsetRight => "m",
            Self::VelocityHigh | Self::VelocityRight | Self::AxialVelocity => "m/s",
            Self::RotarySpeed => "rad/s",
        }
    }
}

/// A place of the string that a quantity is recorded at.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Probe {
    /// Measured depth with the bit at the operation's depth, m. The nearest node is taken, and
    /// moves with the string.
    pub md_m: f64,
    /// What is recorded.
    pub signal: NodeSignal,
}

/// What a probe recorded, one value a sample.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Probed {
    /// The node.
    pub node: usize,
    /// What was recorded.
    pub signal: NodeSignal,
    /// Its samples.
    pub samples: Vec<f64>,
}
