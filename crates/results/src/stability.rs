//! Torsional stability in JSON.

use serde::{Deserialize, Serialize};
use wholestring_vibration::torsional_stability::{
    StabilityLine, StabilityOfCase, StabilityPoint, Threshold,
};

use crate::row::{named, rows};

/// Stable range of steady rotation, in `summary.json`: `everywhere` or `nowhere` on the map, or
/// `from` a speed on.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct StableFrom {
    /// Kind of the range.
    pub stable: StableWhere,
    /// The speed, rad/s; none except for `from`.
    pub threshold_rad_per_s: Option<f64>,
}

/// Stable range on the map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum StableWhere {
    /// At all speeds.
    Everywhere,
    /// From a speed on.
    From,
    /// Not even at the fastest.
    Nowhere,
}

impl StableWhere {
    /// Its word in files.
    const fn name(self) -> &'static str {
        match self {
            Self::Everywhere => "everywhere",
            Self::From => "from",
            Self::Nowhere => "nowhere",
        }
    }
}

named! {
    StableWhere: name;
}

impl From<Threshold> for StableFrom {
    fn from(threshold: Threshold) -> Self {
        let (stable, threshold_rad_per_s) = match threshold {
            Threshold::Everywhere => (StableWhere::Everywhere, None),
            Threshold::From(speed) => (StableWhere::From, Some(speed)),
            Threshold::Nowhere => (StableWhere::Nowhere, None),
        };
        Self { stable, threshold_rad_per_s }
    }
}

/// A speed of the map, and the weight on bit of its line.
#[derive(Debug, Clone, Copy)]
pub struct StabilityRow<'a> {
    /// The weight at all speeds.
    pub line: &'a StabilityLine,
    /// Its speed.
    pub point: &'a StabilityPoint,
}

rows! {
    for StabilityRow<'_> {
        weight_on_bit_N = |row| row.point.weight_on_bit_N => Force, "Weight on bit";
        rotary_speed_rad_per_s = |row| row.point.rotary_speed_rad_per_s => RotarySpeed,
            "Rotary speed at surface";
        unstable_roots = |row| row.point.stability.unstable_roots => Ratio,
            "Growing roots of the linear vibration, a pair counted twice";
        growth_per_s = |row| row.point.stability.worst.map(|worst| worst.growth_per_s) => Growth,
            "Growth rate of the fastest growing motion; negative where all decay, `null` where \
             none was found",
            null_where "none was found";
        frequency_Hz = |row| row.point.stability.worst.map(|worst| worst.frequency_Hz) => Frequency,
            "Its frequency, `null` where none was found",
            null_where "none was found";
        complete = |row| row.point.stability.complete => Ratio,
            "1 where all growing motions were followed; 0 where `growth_per_s` is a lower bound of \
             the largest growth";
        stable = |row| StableFrom::from(row.line.threshold).stable => Words,
            "Stability of this weight: `everywhere` on the map, `from` a speed on, or `nowhere`: \
             not even at the fastest";
        threshold_rad_per_s = |row| StableFrom::from(row.line.threshold).threshold_rad_per_s
            => RotarySpeed,
            "Rotary speed from which it is stable, `null` where it is stable everywhere or nowhere",
            null_where "the weight is stable at all speeds of the map, or not even at the fastest";
        surface_torque_N_m = |row| row.line.surface_torque_N_m => Torque,
            "Torque at the top while the string turns steadily";
        stalls = |row| row.line.stalls => Ratio,
            "1 where that exceeds the torque of the top drive, else 0";
        lies_by = |row| row.line.lies_by => Words,
            "Method that computed the string's position in the hole: `stiff`, or `soft` where that \
             found no equilibrium";
    }

    /// Columns of `stability.parquet`: the map of torsional stability, a row for each rotary speed
    /// at each weight on bit.
    pub const STABILITY;
}

impl<'a> StabilityRow<'a> {
    /// The rows of these lines.
    pub fn all(lines: &'a [StabilityLine]) -> impl Iterator<Item = Self> {
        lines.iter().flat_map(|line| line.points.iter().map(move |point| Self { line, point }))
    }
}

/// A controller of the top drive that was tried.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct TriedController {
    /// Its impedance over that of the uppermost pipe: `impedance_ratio` of SoftTorque.
    pub impedance_ratio: f64,
    /// Its proportional gain, N·m·s.
    pub proportional_N_m_s: f64,
    /// Its integral gain, N·m.
    pub integral_N_m: f64,
    /// Part of a wave of the string's lowest torsional frequency that it sends back.
    pub reflection: f64,
    /// Speeds at which the case's weight is stable with it.
    #[serde(flatten)]
    pub from: StableFrom,
}

/// Torsional stability of the case's own speed and weight, and its top drive.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StabilitySummary {
    /// Rotary speed at surface, rad/s.
    pub rotary_speed_rad_per_s: f64,
    /// Weight on bit, N.
    pub weight_on_bit_N: f64,
    /// Growing roots, a pair counted twice.
    pub unstable_roots: usize,
    /// Growth rate of the fastest growing motion, 1/s; negative where all decay.
    pub growth_per_s: Option<f64>,
    /// Its frequency, Hz.
    pub frequency_Hz: Option<f64>,
    /// Whether all growing motions were followed.
    pub complete: bool,
    /// Whether neither the bit's torque nor friction falls with speed, so that only the rate of
    /// penetration drives growing motions.
    #[serde(default)]
    pub driven_by_rate: bool,
    /// Speeds at which this weight is stable.
    #[serde(flatten)]
    pub from: StableFrom,
    /// The rotary speed over that speed, less one.
    pub margin: Option<f64>,
    /// Torque at the top while the string turns steadily, N·m.
    pub surface_torque_N_m: f64,
    /// Whether that exceeds the torque of the top drive.
    pub stalls: bool,
    /// Method that computed the string's position in the hole: `stiff` or `soft`.
    pub lies_by: String,
    /// Highest frequency that was examined, Hz.
    pub highest_frequency_Hz: f64,
    /// Lowest torsional frequency of the string, held at the top and free at the bit, Hz.
    pub string_frequency_Hz: f64,
    /// Characteristic torsional impedance of the uppermost pipe, N·m·s.
    pub pipe_impedance_N_m_s: f64,
    /// Frequencies, Hz, and the part of a torsional wave of each that the top drive sends back.
    pub reflections: Vec<[f64; 2]>,
    /// A better controller; none where none is needed, or none that was tried is better.
    pub better_controller: Option<TriedController>,
}

impl StabilitySummary {
    /// Summarizes the stability of motions up to a frequency, Hz.
    pub fn new(case: &StabilityOfCase, highest_frequency_Hz: f64) -> Self {
        let worst = case.stability.worst;
        Self {
            rotary_speed_rad_per_s: case.rotary_speed_rad_per_s,
            weight_on_bit_N: case.weight_on_bit_N,
            unstable_roots: case.stability.unstable_roots,
            growth_per_s: worst.map(|worst| worst.growth_per_s),
            frequency_Hz: worst.map(|worst| worst.frequency_Hz),
            complete: case.stability.complete,
            driven_by_rate: false,
            from: case.threshold.into(),
            margin: case.margin(),
            surface_torque_N_m: case.surface_torque_N_m,
            stalls: case.stalls,
            lies_by: case.lies_by.name().to_owned(),
            highest_frequency_Hz,
            string_frequency_Hz: case.string_frequency_Hz,
            pipe_impedance_N_m_s: case.pipe_impedance_N_m_s,
            reflections: case.reflections.to_vec(),
            better_controller: case.tuned.map(|tuned| TriedController {
                impedance_ratio: tuned.impedance_ratio,
                proportional_N_m_s: tuned.gains.proportional_N_m_s,
                integral_N_m: tuned.gains.integral_N_m,
                reflection: tuned.reflection,
                from: tuned.threshold.into(),
            }),
        }
    }
}
