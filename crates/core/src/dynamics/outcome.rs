//! What a dynamic run answers.

use serde::{Deserialize, Serialize};

use crate::outcome::Scalars;

/// Distribution of one quantity over the window.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Statistic {
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub std: f64,
    /// Smallest sample.
    pub min: f64,
    /// Largest sample.
    pub max: f64,
    /// 5th percentile.
    pub p05: f64,
    /// 95th percentile.
    pub p95: f64,
}

impl Statistic {
    /// The distribution of `samples`; none of an empty slice. Percentiles are interpolated linearly
    /// between order statistics.
    pub fn of(samples: &[f64]) -> Option<Self> {
        let n = samples.len();
        if n == 0 {
            return None;
        }
        let mean = samples.iter().sum::<f64>() / n as f64;
        let variance = samples.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / n as f64;
        let mut sorted = samples.to_vec();
        sorted.sort_by(f64::total_cmp);
        let percentile = |part: f64| {
            let place = part * (n - 1) as f64;
            let low = place.floor() as usize;
            let high = (low + 1).min(n - 1);
            sorted[low] + (place - low as f64) * (sorted[high] - sorted[low])
        };
        Some(Self {
            mean,
            std: variance.sqrt(),
            min: sorted[0],
            max: sorted[n - 1],
            p05: percentile(0.05),
            p95: percentile(0.95),
        })
    }
}

/// How the run was computed and how well.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Numerics {
    /// Number of elements.
    pub elements: usize,
    /// Step, s.
    pub time_step_s: f64,
    /// Steps done.
    pub steps: u64,
    /// Axial mass lent to short elements over that of the string.
    pub added_axial_mass_fraction: f64,
    /// Deepest penetration of the wall at any sample, m.
    pub max_penetration_m: f64,
    /// Work put in at top drive, hoist and bit less the change of energy and every loss, over the
    /// largest of them and of the kinetic energy: what the integration itself gained or lost. From the
    /// start of the window.
    pub energy_residual: f64,
    /// Instruction set that the time loop was compiled for.
    pub instructions: &'static str,
}

/// The string's profile over the window, by measured depth from the surface down. All of the same
/// length, one row per node; tension and torque are means of the two elements at the node.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct NodeProfile {
    /// Measured depth at the middle of the window, m.
    pub md_m: Vec<f64>,
    /// Mean effective tension, N.
    pub tension_N: Vec<f64>,
    /// Standard deviation of tension, N.
    pub tension_std_N: Vec<f64>,
    /// Mean torque, N·m.
    pub torque_N_m: Vec<f64>,
    /// Standard deviation of torque, N·m.
    pub torque_std_N_m: Vec<f64>,
    /// Mean signed side force per metre, positive on the high side, N/m: the contact forces of the
    /// nodes around, over the length of string that they carry.
    pub side_force_N_per_m: Vec<f64>,
    /// Mean contact force of the node itself, N.
    pub contact_force_N: Vec<f64>,
    /// Standard deviation of the contact force, N.
    pub contact_force_std_N: Vec<f64>,
    /// Largest contact force of any sample, N.
    pub contact_force_max_N: Vec<f64>,
    /// Part of the samples in which the node touched the wall.
    pub contact_fraction: Vec<f64>,
    /// Angle of the node's mean contact force from the low side, rad, from −π to π, positive to the right
    /// looking down the hole; none where it never touched. A pipe that turns clockwise climbs to the
    /// right.
    pub climb_rad: Vec<Option<f64>>,
    /// Mean axial friction per metre, N/m; positive adds to hook load.
    pub axial_friction_N_per_m: Vec<f64>,
    /// Mean friction torque per metre, N.
    pub friction_torque_N_m_per_m: Vec<f64>,
    /// Mean distance of the pipe's axis from the hole's, m.
    pub lateral_offset_m: Vec<f64>,
    /// Work of friction over the window per metre of string, J/m.
    pub wear_work_J_per_m: Vec<f64>,
}

/// Work of friction on the hole over the window, from the surface down, one row per stretch of hole.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct HoleWear {
    /// Measured depth of the middle of the stretch, m.
    pub md_m: Vec<f64>,
    /// Work per metre of hole, J/m: friction force times sliding distance.
    pub wear_work_J_per_m: Vec<f64>,
    /// Its mean rate, W/m.
    pub wear_power_W_per_m: Vec<f64>,
}

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
    /// Rock that a revolution of the bit takes away, m; not a number where a motor turns it at a speed that is
    /// not given.
    pub depth_of_cut_m: Vec<f64>,
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
    /// Line of the schedule that began last, counted from one; zero before the first.
    pub schedule_line: Vec<usize>,
}

/// Everything that a run answers.
#[derive(Debug, Clone, PartialEq)]
pub struct DynamicOutcome {
    /// Means over the window under the names that every solver shares.
    pub scalars: Scalars,
    /// Distributions over the window of the scalars that vary, by their name.
    pub statistics: Vec<(&'static str, Statistic)>,
    /// How it was computed.
    pub numerics: Numerics,
    /// Profile along the string.
    pub nodes: NodeProfile,
    /// Wear along the hole.
    pub wear: HoleWear,
    /// Scalars against time.
    pub series: TimeSeries,
}
