//! What of a run a spectrum can be taken of: scalars, and quantities of single nodes.

use serde::Serialize;

use super::time_series::TimeSeries;

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
