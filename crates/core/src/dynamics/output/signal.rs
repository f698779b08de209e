//! What of a run a spectrum can be taken of: scalars, and quantities of single nodes.

use serde::{Deserialize, Serialize};

use super::outcome::TimeSeries;

/// A scalar against time.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
pub enum Signal {
    /// Hook load.
    HookLoad,
    /// Surface torque.
    SurfaceTorque,
    /// Friction torque.
    FrictionTorque,
    /// Axial friction.
    AxialFriction,
    /// Side force, summed along the string.
    SideForceTotal,
    /// Weight on bit.
    WeightOnBit,
    /// Bit torque.
    BitTorque,
    /// Rotary speed of the bit.
    BitRotarySpeed,
    /// Block velocity.
    BlockVelocity,
    /// Turn of the top against the bit.
    Twist,
    /// Elongation.
    Stretch,
}

impl Signal {
    /// Every signal.
    pub const ALL: [Self; 11] = [
        Self::HookLoad,
        Self::SurfaceTorque,
        Self::FrictionTorque,
        Self::AxialFriction,
        Self::SideForceTotal,
        Self::WeightOnBit,
        Self::BitTorque,
        Self::BitRotarySpeed,
        Self::BlockVelocity,
        Self::Twist,
        Self::Stretch,
    ];

    /// Name in case files and results.
    pub const fn name(self) -> &'static str {
        match self {
            Self::HookLoad => "hook_load",
            Self::SurfaceTorque => "surface_torque",
            Self::FrictionTorque => "friction_torque",
            Self::AxialFriction => "axial_friction",
            Self::SideForceTotal => "side_force_total",
            Self::WeightOnBit => "weight_on_bit",
            Self::BitTorque => "bit_torque",
            Self::BitRotarySpeed => "bit_rotary_speed",
            Self::BlockVelocity => "block_velocity",
            Self::Twist => "twist",
            Self::Stretch => "stretch",
        }
    }

    /// Symbol of its unit.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::HookLoad | Self::AxialFriction | Self::SideForceTotal | Self::WeightOnBit => "N",
            Self::SurfaceTorque | Self::FrictionTorque | Self::BitTorque => "N·m",
            Self::BitRotarySpeed => "rad/s",
            Self::BlockVelocity => "m/s",
            Self::Twist => "rad",
            Self::Stretch => "m",
        }
    }

    /// Its samples.
    pub fn of(self, series: &TimeSeries) -> &[f64] {
        match self {
            Self::HookLoad => &series.hook_load_N,
            Self::SurfaceTorque => &series.surface_torque_N_m,
            Self::FrictionTorque => &series.friction_torque_N_m,
            Self::AxialFriction => &series.axial_friction_N,
            Self::SideForceTotal => &series.side_force_total_N,
            Self::WeightOnBit => &series.weight_on_bit_N,
            Self::BitTorque => &series.bit_torque_N_m,
            Self::BitRotarySpeed => &series.bit_rotary_speed_rad_per_s,
            Self::BlockVelocity => &series.block_velocity_m_per_s,
            Self::Twist => &series.twist_rad,
            Self::Stretch => &series.stretch_m,
        }
    }
}

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
    /// Measured depth with the bit at the operation's depth, m. The nearest node is taken, and moves with the string.
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
