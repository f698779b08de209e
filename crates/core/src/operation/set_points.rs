//! Operations with their set points, one after the other.

use super::{Operation, OperationKind};

/// Declares methods that give an operation a set point, named as its field.
macro_rules! set_points {
    ($($(#[$meaning:meta])* $field:ident,)+) => {
        $(
            $(#[$meaning])*
            #[must_use]
            pub const fn $field(mut self, $field: f64) -> Self {
                self.$field = $field;
                self
            }
        )+
    };
}

/// Operations are constructed with a depth and receive the set points that they need:
///
/// ```
/// use wholestring::operation::Operation;
///
/// let drill = Operation::drill(3000.0)
///     .rotary_speed_rad_per_s(12.0)
///     .weight_on_bit_N(80e3)
///     .bit_torque_N_m(4e3)
///     .rate_of_penetration_m_per_s(5e-3);
/// assert_eq!(drill.weight_on_bit_now_N(), 80e3);
/// assert_eq!(Operation::trip_out(3000.0).axial_velocity_m_per_s(), -0.3);
/// ```
impl Operation {
    /// Speed of tripping and reaming by default, m/s: a stand of 28 m in a minute and a half.
    pub const TRIP_SPEED_M_PER_S: f64 = 0.3;

    /// An operation with the bit at a measured depth, m: tripping and reaming at
    /// [`Self::TRIP_SPEED_M_PER_S`], every other set point zero. Solvers refuse one that turns
    /// without a rotary speed.
    pub const fn new(kind: OperationKind, bit_depth_m: f64) -> Self {
        Self {
            kind,
            bit_depth_m,
            rotary_speed_rad_per_s: 0.0,
            weight_on_bit_N: 0.0,
            bit_pull_N: 0.0,
            bit_torque_N_m: 0.0,
            rate_of_penetration_m_per_s: 0.0,
            trip_speed_m_per_s: Self::TRIP_SPEED_M_PER_S,
            flow_rate_m3_per_s: 0.0,
            bit_pressure_drop_Pa: 0.0,
            motor_pressure_drop_Pa: 0.0,
        }
    }

    set_points! {
        /// With a rotary speed at surface, rad/s, clockwise looking down the hole.
        rotary_speed_rad_per_s,
        /// With a weight on bit, N, positive in compression.
        weight_on_bit_N,
        /// With a pull on the bit off bottom, N.
        bit_pull_N,
        /// With the torque of the bit at the weight on bit, N·m.
        bit_torque_N_m,
        /// With the rate of penetration at the weight on bit and the rotary speed, m/s.
        rate_of_penetration_m_per_s,
        /// With a speed of tripping and reaming, m/s, positive.
        trip_speed_m_per_s,
        /// With a flow rate of the pumps, m³/s.
        flow_rate_m3_per_s,
        /// With the pressure drop of the bit's nozzles at that flow rate, Pa.
        bit_pressure_drop_Pa,
        /// With the pressure drop of a mud motor that gives the torque of the bit, Pa.
        motor_pressure_drop_Pa,
    }
}
