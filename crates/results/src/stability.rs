//! What is written of torsional stability as JSON.

use serde::{Deserialize, Serialize};
use wholestring::torsional_stability::{StabilityOfCase, Threshold};

/// Where steady rotation is stable, in `summary.json`: `everywhere` or `nowhere` on the map, or
/// `from` a speed on.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct StableFrom {
    /// Which.
    pub stable: StableWhere,
    /// The speed, rad/s; none but of `from`.
    pub threshold_rad_per_s: Option<f64>,
}

/// Where on the map.
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
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Everywhere => "everywhere",
            Self::From => "from",
            Self::Nowhere => "nowhere",
        }
    }
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
    /// Where it makes the case's weight stable.
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
    /// Roots that grow, a pair counted twice.
    pub unstable_roots: usize,
    /// How fast the motion grows that grows most, 1/s; negative where all die away.
    pub growth_per_s: Option<f64>,
    /// Its frequency, Hz.
    pub frequency_Hz: Option<f64>,
    /// Whether as many growing motions were followed as there are.
    pub complete: bool,
    /// Whether neither the bit's torque nor friction falls with speed, so that only the rate of
    /// penetration drives what grows.
    #[serde(default)]
    pub driven_by_rate: bool,
    /// From which speed on this weight is stable.
    #[serde(flatten)]
    pub from: StableFrom,
    /// The speed over that, less one.
    pub margin: Option<f64>,
    /// Torque at the top while the string turns steadily, N·m.
    pub surface_torque_N_m: f64,
    /// Whether that is more than the top drive gives.
    pub stalls: bool,
    /// Method that said how the string lies: `stiff` or `soft`.
    pub lies_by: String,
    /// Fastest motion that was looked at, Hz.
    pub highest_frequency_Hz: f64,
    /// Lowest torsional frequency of the string, held at the top and free at the bit, Hz.
    pub string_frequency_Hz: f64,
    /// Characteristic torsional impedance of the uppermost pipe, N·m·s.
    pub pipe_impedance_N_m_s: f64,
    /// Frequencies, Hz, and the part of a torsional wave of each that the top drive sends back.
    pub reflections: Vec<[f64; 2]>,
    /// A better controller; none where none is needed, or none that was tried is.
    pub better_controller: Option<TriedController>,
}

impl StabilitySummary {
    /// Of what was found, looking at motions up to a frequency, Hz.
    pub fn new(of: &StabilityOfCase, highest_frequency_Hz: f64) -> Self {
        let worst = of.stability.worst;
        Self {
            rotary_speed_rad_per_s: of.rotary_speed_rad_per_s,
            weight_on_bit_N: of.weight_on_bit_N,
            unstable_roots: of.stability.unstable_roots,
            growth_per_s: worst.map(|of| of.growth_per_s),
            frequency_Hz: worst.map(|of| of.frequency_Hz),
            complete: of.stability.complete,
            driven_by_rate: false,
            from: of.threshold.into(),
            margin: of.margin(),
            surface_torque_N_m: of.surface_torque_N_m,
            stalls: of.stalls,
            lies_by: of.lies_by.name().to_owned(),
            highest_frequency_Hz,
            string_frequency_Hz: of.string_frequency_Hz,
            pipe_impedance_N_m_s: of.pipe_impedance_N_m_s,
            reflections: of.reflections.to_vec(),
            better_controller: of.tuned.map(|of| TriedController {
                impedance_ratio: of.impedance_ratio,
                proportional_N_m_s: of.gains.proportional_N_m_s,
                integral_N_m: of.gains.integral_N_m,
                reflection: of.reflection,
                from: of.threshold.into(),
            }),
        }
    }
}
