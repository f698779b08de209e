//! What a dynamic run answers.

use std::borrow::Cow;

use serde::{Deserialize, Serialize};

use super::{
    bit::TableUse,
    drift::{Drift, MATTERS, SIGNIFICANT, mean, standard_error},
    energy::EnergyBalance,
    indicators::Indicators,
};
use crate::{
    mud::Hydraulics,
    outcome::{ContactMap, HoleWear, Profile, Scalars, TimeSeries},
};

/// Distribution of one quantity over the window.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Statistic {
    /// Mean.
    #[serde(with = "crate::finite::unsigned_zero")]
    pub mean: f64,
    /// Standard deviation.
    #[serde(with = "crate::finite::unsigned_zero")]
    pub std: f64,
    /// Smallest sample.
    #[serde(with = "crate::finite::unsigned_zero")]
    pub min: f64,
    /// Largest sample.
    #[serde(with = "crate::finite::unsigned_zero")]
    pub max: f64,
    /// 5th percentile.
    #[serde(with = "crate::finite::unsigned_zero")]
    pub p05: f64,
    /// 95th percentile.
    #[serde(with = "crate::finite::unsigned_zero")]
    pub p95: f64,
    /// Standard error of the mean, by block averages: the samples depend on their neighbours. Flyvbjerg and Petersen,
    /// *Error estimates on averages of correlated data*, J. Chem. Phys. 91 (1989). Not a
    /// number in files that do not have it.
    #[serde(
        with = "crate::finite::unsigned_zero",
        default = "crate::finite::unknown"
    )]
    pub std_error: f64,
    /// Change over the window by the straight line of least squares; not a number in files that do
    /// not have it.
    #[serde(
        with = "crate::finite::unsigned_zero",
        default = "crate::finite::unknown"
    )]
    pub drift: f64,
    /// Whether that is no chance and matters: more than four of its standard errors, or the means of the halves are as
    /// far apart, and more than half a percent of the quantity's scale. The deviation is then that drift, too.
    #[serde(default)]
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
pub(super) fn percentile<T: Copy + Into<f64>>(samples: &mut [T], part: f64) -> f64 {
    let order = |a: &T, b: &T| (*a).into().total_cmp(&(*b).into());
    let place = part * (samples.len() - 1) as f64;
    let low = place.floor();
    let (_, at, above) = samples.select_nth_unstable_by(low as usize, order);
    let at: f64 = (*at).into();
    let next = above.iter().min_by(|a, b| order(a, b));
    at + (place - low) * (next.map_or(at, |next| (*next).into()) - at)
}

/// How the run was computed and how well.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Numerics {
    /// Number of elements.
    pub elements: usize,
    /// Step, s.
    #[serde(with = "crate::finite::unsigned_zero")]
    pub time_step_s: f64,
    /// Steps done.
    pub steps: u64,
    /// Axial mass lent to short elements over that of the string.
    #[serde(with = "crate::finite::unsigned_zero")]
    pub added_axial_mass_fraction: f64,
    /// Deepest penetration of the wall at any sample, m, by the geometry: of the nodes that touch it, and of the bit,
    /// which is held to the axis of the hole that it cuts.
    #[serde(with = "crate::finite::unsigned_zero")]
    pub max_penetration_m: f64,
    /// Work put in at top drive, hoist and bit less the change of energy and every loss, over the
    /// largest of them, of the kinetic energy and of what lifts the string by a millimetre: what the integration itself
    /// gained or lost. From the start of the window. 1, and no parts, in a run that diverged.
    #[serde(with = "crate::finite::unsigned_zero")]
    pub energy_residual: f64,
    /// Its parts; none before the window began and in a run that diverged.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub energy: Option<EnergyBalance>,
    /// Instruction set that the time loop was compiled for.
    pub instructions: Cow<'static, str>,
    /// Time at which the window begins, s: that of its first sample, at the earliest. The time reached of a run that settles yet.
    /// Not a number in files of versions that did not say.
    #[serde(
        with = "crate::finite::unsigned_zero",
        default = "crate::finite::unknown",
        skip_serializing_if = "crate::finite::is_unknown"
    )]
    pub settle_s: f64,
    /// Whether the string was steady then; none where the time was given, and of a run that settles yet.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub settled: Option<bool>,
    /// Measured depth of the bit, on average over the window, m; as [`Self::settle_s`].
    #[serde(
        with = "crate::finite::unsigned_zero",
        default = "crate::finite::unknown",
        skip_serializing_if = "crate::finite::is_unknown"
    )]
    pub mean_bit_depth_m: f64,
    /// How far the bit went in the window, m, positive downwards; as [`Self::settle_s`].
    #[serde(
        with = "crate::finite::unsigned_zero",
        default = "crate::finite::unknown",
        skip_serializing_if = "crate::finite::is_unknown"
    )]
    pub bit_travel_m: f64,
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
    pub nodes: Profile,
    /// Wear along the hole.
    pub wear: HoleWear,
    /// Contact over depth and time.
    pub contact: ContactMap,
    /// Scalars against time.
    pub series: TimeSeries,
}
