//! Scalars against time.

use serde::{Deserialize, Serialize};

use super::probe::Probed;
use crate::damage::{Damaged, sound};

/// Scalars against time, from time zero; rows are samples, contact quantities averages over them.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct TimeSeries {
    /// Time, s.
    pub time_s: Vec<f64>,
    /// Measured depth of the bit, m.
    pub bit_depth_m: Vec<f64>,
    /// Hook load, N.
    pub hook_load_N: Vec<f64>,
    /// Surface torque, N·m.
    pub surface_torque_N_m: Vec<f64>,
    /// Friction torque, N·m.
    pub friction_torque_N_m: Vec<f64>,
    /// Axial friction, N.
    pub axial_friction_N: Vec<f64>,
    /// Side force, N.
    pub side_force_total_N: Vec<f64>,
    /// Weight on bit, N.
    pub weight_on_bit_N: Vec<f64>,
    /// Bit torque, N·m.
    pub bit_torque_N_m: Vec<f64>,
    /// Force of rock and hole on the bit towards the high side of the hole, N.
    pub bit_force_high_N: Vec<f64>,
    /// Force of rock and hole on the bit to the right of that, looking down the hole, N.
    pub bit_force_right_N: Vec<f64>,
    /// Magnitude of the bending moment of solid rock on the bit, N·m; zero of other rock.
    pub bit_moment_N_m: Vec<f64>,
    /// Rock that a revolution of the bit takes away, m; zero where a motor turns it at a speed that is not
    /// given.
    pub depth_of_cut_m: Vec<f64>,
    /// Rock that the bit takes away per time, m/s.
    pub rate_of_penetration_m_per_s: Vec<f64>,
    /// Speed of the mud motor against the string, rad/s; none without a motor.
    pub motor_speed_rad_per_s: Vec<Option<f64>>,
    /// Pressure that the mud motor takes off the mud, Pa; none of a motor of which the speed alone is known.
    pub motor_pressure_Pa: Vec<Option<f64>>,
    /// Turn of the top against the bit, rad.
    pub twist_rad: Vec<f64>,
    /// Elongation, m.
    pub stretch_m: Vec<f64>,
    /// Block velocity, m/s, positive downwards.
    pub block_velocity_m_per_s: Vec<f64>,
    /// Rotary speed of the bit, rad/s.
    pub bit_rotary_speed_rad_per_s: Vec<f64>,
    /// Rotary speed at surface, rad/s.
    pub rotary_speed_rad_per_s: Vec<f64>,
    /// What it is set to, rad/s.
    pub rotary_speed_set_rad_per_s: Vec<f64>,
    /// Block velocity that is set, m/s, positive downwards; none where something else is.
    pub block_velocity_set_m_per_s: Vec<Option<f64>>,
    /// Weight on bit that the autodriller is set to, N; none where it is not in control.
    pub weight_on_bit_set_N: Vec<Option<f64>>,
    /// What the pumps deliver, m³/s.
    pub flow_rate_m3_per_s: Vec<f64>,
    /// Pressure that they deliver at, Pa; none without a rheology.
    pub pump_pressure_Pa: Vec<Option<f64>>,
    /// Line of the schedule that began last, counted from one; zero before the first.
    pub schedule_line: Vec<usize>,
    /// Measured depth of the shallowest zero of effective tension, m, if there is one.
    pub neutral_point_m: Vec<Option<f64>>,
    /// Deepest change of the side force from high to low side over the second before, m: one value a
    /// second, none between.
    pub cutoff_depth_m: Vec<Option<f64>>,
    /// What single nodes showed, as the settings ask for it.
    pub probes: Vec<Probed>,
}

impl TimeSeries {
    /// Whether a stored series is one of so many nodes, all its columns of one length; how many rows it has.
    pub(in crate::dynamics) fn check(&self, nodes: usize) -> Result<usize, Damaged> {
        // Every field is named: a new one is looked at too.
        let Self {
            time_s,
            bit_depth_m,
            hook_load_N,
            surface_torque_N_m,
            friction_torque_N_m,
            axial_friction_N,
            side_force_total_N,
            weight_on_bit_N,
            bit_torque_N_m,
            bit_force_high_N,
            bit_force_right_N,
            bit_moment_N_m,
            depth_of_cut_m,
            rate_of_penetration_m_per_s,
            motor_speed_rad_per_s,
            motor_pressure_Pa,
            twist_rad,
            stretch_m,
            block_velocity_m_per_s,
            bit_rotary_speed_rad_per_s,
            rotary_speed_rad_per_s,
            rotary_speed_set_rad_per_s,
            block_velocity_set_m_per_s,
            weight_on_bit_set_N,
            flow_rate_m3_per_s,
            pump_pressure_Pa,
            schedule_line,
            neutral_point_m,
            cutoff_depth_m,
            probes,
        } = self;
        let rows = time_s.len();
        let numbers = [
            bit_depth_m,
            hook_load_N,
            surface_torque_N_m,
            friction_torque_N_m,
            axial_friction_N,
            side_force_total_N,
            weight_on_bit_N,
            bit_torque_N_m,
            bit_force_high_N,
            bit_force_right_N,
            bit_moment_N_m,
            depth_of_cut_m,
            rate_of_penetration_m_per_s,
            twist_rad,
            stretch_m,
            block_velocity_m_per_s,
            bit_rotary_speed_rad_per_s,
            rotary_speed_rad_per_s,
            rotary_speed_set_rad_per_s,
            flow_rate_m3_per_s,
        ];
        let some = [
            motor_speed_rad_per_s,
            motor_pressure_Pa,
            block_velocity_set_m_per_s,
            weight_on_bit_set_N,
            pump_pressure_Pa,
            neutral_point_m,
            cutoff_depth_m,
        ];
        let fits = numbers.iter().all(|column| column.len() == rows)
            && some.iter().all(|column| column.len() == rows)
            && schedule_line.len() == rows
            && probes
                .iter()
                .all(|probe| probe.node < nodes && probe.samples.len() == rows);
        sound(fits, "the series against time")?;
        Ok(rows)
    }
}
