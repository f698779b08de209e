//! Quantities of single nodes against time.

use serde::{Deserialize, Serialize};

/// A quantity of a node against time, read at the end of each sample but for the contact force.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum NodeSignal {
    /// Effective tension.
    Tension,
    /// Torque.
    Torque,
    /// Bending moment, whatever its direction.
    BendingMoment,
    /// Von Mises stress.
    VonMisesStress,
    /// Contact force, averaged over the sample; positive on the high side.
    ContactForce,
    /// Offset from the hole's axis towards the high side.
    OffsetHigh,
    /// Offset to the right of it.
    OffsetRight,
    /// Velocity towards the high side.
    VelocityHigh,
    /// Velocity to the right of it.
    VelocityRight,
    /// Velocity down the hole.
    AxialVelocity,
    /// Rotary speed.
    RotarySpeed,
}

impl NodeSignal {
    /// Every signal.
    pub const ALL: [Self; 11] = [
        Self::Tension,
        Self::Torque,
        Self::BendingMoment,
        Self::VonMisesStress,
        Self::ContactForce,
        Self::OffsetHigh,
        Self::OffsetRight,
        Self::VelocityHigh,
        Self::VelocityRight,
        Self::AxialVelocity,
        Self::RotarySpeed,
    ];

    /// Name in case files and results.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Tension => "tension",
            Self::Torque => "torque",
            Self::BendingMoment => "bending_moment",
            Self::VonMisesStress => "von_mises_stress",
            Self::ContactForce => "contact_force",
            Self::OffsetHigh => "offset_high",
            Self::OffsetRight => "offset_right",
            Self::VelocityHigh => "velocity_high",
            Self::VelocityRight => "velocity_right",
            Self::AxialVelocity => "axial_velocity",
            Self::RotarySpeed => "rotary_speed",
        }
    }

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
