//! The scalars against time that have spectra.

use serde::Serialize;

use super::{
    signals::signals,
    time_series::{TIME_SERIES, TimeSeries},
};

signals! {
    /// A scalar against time.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
    pub enum Signal of TimeSeries in TIME_SERIES {
        /// Hook load.
        HookLoad => hook_load_N;
        /// Surface torque.
        SurfaceTorque => surface_torque_N_m;
        /// Friction torque.
        FrictionTorque => friction_torque_N_m;
        /// Axial friction.
        AxialFriction => axial_friction_N;
        /// Side force, summed along the string.
        SideForceTotal => side_force_total_N;
        /// Weight on bit.
        WeightOnBit => weight_on_bit_N;
        /// Bit torque.
        BitTorque => bit_torque_N_m;
        /// Rotary speed of the bit.
        BitRotarySpeed => bit_rotary_speed_rad_per_s;
        /// Block velocity.
        BlockVelocity => block_velocity_m_per_s;
        /// Turn of the top against the bit.
        Twist => twist_rad;
        /// Elongation.
        Stretch => stretch_m;
    }
}
