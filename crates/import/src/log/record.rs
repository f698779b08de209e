//! A row of a log.

/// Values of the sensors of a rig at one time; NaN where a sensor has none.
///
/// Readers of logs return these one after the other, whatever the length of the log.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Record {
    /// Time since the log's first row, s. NaN in a log against depth.
    pub time_s: f64,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// Measured depth of the hole, m.
    pub hole_depth_m: f64,
    /// Height of the travelling block, m.
    pub block_position_m: f64,
    /// Hook load as it was logged, including the block's weight where the block hangs on the
    /// sensor, N.
    pub hook_load_N: f64,
    /// Weight on bit as the rig computes it, N.
    pub weight_on_bit_N: f64,
    /// Torque at the surface, N·m.
    pub torque_N_m: f64,
    /// Rotary speed at the surface, rad/s.
    pub rotary_speed_rad_per_s: f64,
    /// Flow rate of the pumps, m³/s.
    pub flow_rate_m3_per_s: f64,
    /// Pressure at the standpipe, Pa.
    pub standpipe_pressure_Pa: f64,
}

impl Record {
    /// A row without values.
    pub const NONE: Record = Record {
        time_s: f64::NAN,
        bit_depth_m: f64::NAN,
        hole_depth_m: f64::NAN,
        block_position_m: f64::NAN,
        hook_load_N: f64::NAN,
        weight_on_bit_N: f64::NAN,
        torque_N_m: f64::NAN,
        rotary_speed_rad_per_s: f64::NAN,
        flow_rate_m3_per_s: f64::NAN,
        standpipe_pressure_Pa: f64::NAN,
    };
}
