//! What a dynamic run answers.

use serde::{Deserialize, Serialize};

use super::{
    drift::{Drift, MATTERS, SIGNIFICANT, mean, standard_error},
    energy::EnergyBalance,
    indicators::Indicators,
    signal::Probed,
};
use crate::{
    damage::{Damaged, sound},
    dynamics::boundary::bit::TableUse,
    mud::Hydraulics,
    outcome::Scalars,
};

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
    /// Standard error of the mean, by block averages: the samples depend on their neighbours. Flyvbjerg and Petersen,
    /// *Error estimates on averages of correlated data*, J. Chem. Phys. 91 (1989).
    pub std_error: f64,
    /// Change over the window by the straight line of least squares.
    pub drift: f64,
    /// Whether that is no chance and matters: more than four of its standard errors, or the means of the halves are as
    /// far apart, and more than half a percent of the quantity's scale. The deviation is then that drift, too.
    pub drifts: bool,
}

impl Statistic {
    /// The distribution of `samples`; none of an empty slice. Percentiles are interpolated linearly
    /// between order statistics. Its drift is judged by the mean.
    pub fn of(samples: &[f64]) -> Option<Self> {
        Self::on_scale(samples, mean(samples).abs())
    }

    /// The same, but a drift matters above half a percent of `scale`.
    pub fn on_scale(samples: &[f64], scale: f64) -> Option<Self> {
        let n = samples.len();
        if n == 0 {
            return None;
        }
        let mean = samples.iter().sum::<f64>() / n as f64;
        let variance = samples.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / n as f64;
        let mut shuffled = samples.to_vec();
        let mut at = |part| percentile(&mut shuffled, part);
        let drift = Drift::of(samples);
        Some(Self {
            mean,
            std: variance.sqrt(),
            min: at(0.0),
            max: at(1.0),
            p05: at(0.05),
            p95: at(0.95),
            std_error: standard_error(samples),
            drift: drift.change,
            drifts: drift.exceeds(SIGNIFICANT, MATTERS * scale),
        })
    }

    /// The value below which that part of the samples lies, from 0 to 1, interpolated linearly between order
    /// statistics; none of an empty slice.
    pub fn percentile(samples: &[f64], part: f64) -> Option<f64> {
        let mut shuffled = samples.to_vec();
        (!samples.is_empty()).then(|| percentile(&mut shuffled, part))
    }
}

/// A percentile of samples, at least one, interpolated linearly between order statistics. The samples are shuffled
/// until these stand where they would if all were sorted, which takes a quarter of the time of sorting.
pub(in crate::dynamics) fn percentile<T: Copy + Into<f64>>(samples: &mut [T], part: f64) -> f64 {
    let order = |a: &T, b: &T| (*a).into().total_cmp(&(*b).into());
    let place = part * (samples.len() - 1) as f64;
    let low = place.floor();
    let (_, at, above) = samples.select_nth_unstable_by(low as usize, order);
    let at: f64 = (*at).into();
    let next = above.iter().min_by(|a, b| order(a, b));
    at + (place - low) * (next.map_or(at, |next| (*next).into()) - at)
}

/// 5th, 50th and 95th percentile at every node, from samples spread evenly over the window.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Percentiles {
    /// 5th percentile.
    pub p05: Vec<f64>,
    /// Median.
    pub p50: Vec<f64>,
    /// 95th percentile.
    pub p95: Vec<f64>,
}

impl Percentiles {
    pub(in crate::dynamics) fn push(&mut self, [p05, p50, p95]: [f64; 3]) {
        self.p05.push(p05);
        self.p50.push(p50);
        self.p95.push(p95);
    }
}

/// How much of the time a node touches the wall.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ContactClass {
    /// In less than a hundredth of the samples.
    None,
    /// Now and then.
    Intermittent,
    /// In more than ninety-nine hundredths of the samples.
    Continuous,
}

impl ContactClass {
    /// The class of a part of the samples.
    pub fn of(contact_fraction: f64) -> Self {
        if contact_fraction < 0.01 {
            Self::None
        } else if contact_fraction <= 0.99 {
            Self::Intermittent
        } else {
            Self::Continuous
        }
    }

    /// Name in results.
    pub const fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Intermittent => "intermittent",
            Self::Continuous => "continuous",
        }
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
    /// Deepest penetration of the wall at any sample, m, by the geometry: of the nodes that touch it, and of the bit,
    /// which is held to the axis of the hole that it cuts.
    pub max_penetration_m: f64,
    /// Work put in at top drive, hoist and bit less the change of energy and every loss, over the
    /// largest of them, of the kinetic energy and of what lifts the string by a millimetre: what the integration itself
    /// gained or lost. From the start of the window. 1, and no parts, in a run that diverged.
    pub energy_residual: f64,
    /// Its parts; none before the window began and in a run that diverged.
    pub energy: Option<EnergyBalance>,
    /// Instruction set that the time loop was compiled for.
    pub instructions: &'static str,
    /// Time at which the window begins, s: that of its first sample, at the earliest. The time reached of a run that settles yet.
    pub settle_s: f64,
    /// Whether the string was steady then; none where the time was given, and of a run that settles yet.
    pub settled: Option<bool>,
    /// Measured depth of the bit, on average over the window, m.
    pub mean_bit_depth_m: f64,
    /// How far the bit went in the window, m, positive downwards.
    pub bit_travel_m: f64,
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
    /// Its percentiles, N/m: those of the contact force of the nodes around, over the same length.
    pub side_force_percentiles_N_per_m: Percentiles,
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
    /// Its mean rate, W/m.
    pub wear_power_W_per_m: Vec<f64>,
    /// Mean turn of the node against the bit, rad, positive where it leads; at the top the scalar's.
    pub twist_rad: Vec<f64>,
    /// Mean elongation of the string between the node and the bit, m, against the unloaded string; at the top the
    /// scalar's.
    pub stretch_m: Vec<f64>,
    /// Percentiles of tension, N.
    pub tension_percentiles_N: Percentiles,
    /// Percentiles of torque, N·m.
    pub torque_percentiles_N_m: Percentiles,
    /// Percentiles of the contact force of the node itself, N.
    pub contact_force_percentiles_N: Percentiles,
    /// Mean pressure of the mud outside, Pa: its weight and what its flow adds.
    pub outside_pressure_Pa: Vec<f64>,
    /// Mean pressure of the mud inside, Pa.
    pub inside_pressure_Pa: Vec<f64>,
    /// Mean force in the metal, N: effective tension, what the mud's pressures pull and press the metal with, and the
    /// momentum of its stream in the bore, `T + p_i A_i − p_o A_o + ρ Q²/A_i`.
    pub true_tension_N: Vec<f64>,
    /// Mean bending moment, N·m, whatever its direction.
    pub bending_moment_N_m: Vec<f64>,
    /// Largest bending moment of any sample, N·m.
    pub bending_moment_max_N_m: Vec<f64>,
    /// Percentiles of the bending moment, N·m.
    pub bending_moment_percentiles_N_m: Percentiles,
    /// Stress that alternates at the surface of the body as it turns, Pa: the mean bending moment over
    /// the section modulus, `M D/2I`.
    pub bending_stress_Pa: Vec<f64>,
    /// Mean von Mises stress where the body's surface bears most, Pa.
    pub von_mises_stress_Pa: Vec<f64>,
    /// Largest von Mises stress of any sample, Pa.
    pub von_mises_stress_max_Pa: Vec<f64>,
    /// That stress over the minimum yield strength, where it is known.
    pub yield_use: Vec<Option<f64>>,
    /// Force that a tool joint carries, N: the side force per metre over the spacing of the joints;
    /// positive on the high side, none where the string has no joints.
    pub side_force_per_joint_N: Vec<Option<f64>>,
    /// Mean angular velocity of the pipe's axis about the hole's, rad/s; clockwise looking down the
    /// hole, as the string turns, is positive.
    pub whirl_rate_rad_per_s: Vec<f64>,
    /// How much of the lateral motion that is, from zero to one.
    pub whirl_coherence: Vec<f64>,
    /// Root mean square of the lateral speed, m/s.
    pub lateral_speed_rms_m_per_s: Vec<f64>,
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

/// Contact over depth and time, coarse: row after row in time, each from the surface down. A stretch of string stands
/// in a row, at most 200 of them, and each row is an average over the time since the one before, at most 201.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct ContactMap {
    /// Time at which the row ends, s.
    pub time_s: Vec<f64>,
    /// Measured depth of the middle of the stretch, m.
    pub md_m: Vec<f64>,
    /// Mean signed side force per metre, positive on the high side, N/m.
    pub side_force_N_per_m: Vec<f64>,
    /// Mean magnitude of the contact force per metre, N/m.
    pub contact_force_N_per_m: Vec<f64>,
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

impl DynamicOutcome {
    /// The scalars that [`Self::statistics`] tells of, in its order.
    pub fn quantities() -> impl Iterator<Item = &'static str> {
        super::summary::varying(&TimeSeries::default())
            .map(|scalar| scalar.name)
            .into_iter()
    }
}

/// Everything that a run answers.
#[derive(Debug, Clone, PartialEq)]
pub struct DynamicOutcome {
    /// Means over the window under the names that every solver shares.
    pub scalars: Scalars,
    /// Distributions over the window of the scalars that vary, by their name.
    pub statistics: Vec<(&'static str, Statistic)>,
    /// What the mud did, on average over the window; none without a rheology.
    pub hydraulics: Option<Hydraulics>,
    /// How it was computed.
    pub numerics: Numerics,
    /// What the motion amounts to, in the figures of the field.
    pub indicators: Indicators,
    /// How often a bit with a table was where the table is not, over the window; none of another bit.
    pub bit_table: Option<TableUse>,
    /// Profile along the string.
    pub nodes: NodeProfile,
    /// Wear along the hole.
    pub wear: HoleWear,
    /// Contact over depth and time.
    pub contact: ContactMap,
    /// Scalars against time.
    pub series: TimeSeries,
}
