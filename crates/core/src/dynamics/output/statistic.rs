//! The distribution of a quantity over the window.

use std::cmp::Ordering;

use serde::{Deserialize, Serialize};

use super::drift::{Drift, MATTERS, SIGNIFICANT, standard_error};
use crate::outcome::{
    DriftScale, History, ScalarHistory, TimeSeries, VARYING,
    samples::{Samples, mean, sorted_at, sum},
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
    /// Standard error of the mean, by block averages: the samples depend on their neighbours.
    /// Flyvbjerg and Petersen, *Error estimates on averages of correlated data*, J. Chem. Phys. 91
    /// (1989). Not a number in files that do not have it.
    #[serde(with = "crate::finite::unsigned_zero", default = "crate::finite::unknown")]
    pub std_error: f64,
    /// Change over the window by the straight line of least squares; not a number in files that do
    /// not have it.
    #[serde(with = "crate::finite::unsigned_zero", default = "crate::finite::unknown")]
    pub drift: f64,
    /// Whether that is no chance and matters: more than four of its standard errors, or the means
    /// of the halves are as far apart, and more than half a percent of the quantity's scale. The
    /// deviation is then that drift, too.
    #[serde(default)]
    pub drifts: bool,
}

/// Moments of samples, independent of their order; sufficient for large numbers of samples.
#[derive(Debug, Clone, Copy)]
pub(in crate::dynamics) struct Moments {
    pub(in crate::dynamics) mean: f64,
    pub(in crate::dynamics) std: f64,
    pub(in crate::dynamics) min: f64,
    pub(in crate::dynamics) max: f64,
}

impl Moments {
    /// Of samples; none of no samples.
    pub(in crate::dynamics) fn of(samples: &(impl Samples + ?Sized)) -> Option<Self> {
        let n = samples.count();
        if n == 0 {
            return None;
        }
        let mean = mean(samples);
        let mut ends: Option<[f64; 2]> = None;
        let squares = sum(samples, |_, x| {
            let [min, max] = ends.unwrap_or([x; 2]);
            let extreme = |a: f64, b: f64, order| if b.total_cmp(&a) == order { b } else { a };
            ends = Some([extreme(min, x, Ordering::Less), extreme(max, x, Ordering::Greater)]);
            (x - mean).powi(2)
        });
        let [min, max] = ends?;
        Some(Self { mean, std: (squares / n as f64).sqrt(), min, max })
    }
}

impl Statistic {
    /// The distribution of `samples`; none of no samples. Percentiles are interpolated linearly
    /// between order statistics. Its drift is judged by the mean.
    pub fn of(samples: &(impl Samples + ?Sized)) -> Option<Self> {
        Self::on_scale(samples, mean(samples).abs())
    }

    /// The same, but a drift matters above half a percent of `scale`.
    pub fn on_scale(samples: &(impl Samples + ?Sized), scale: f64) -> Option<Self> {
        let Moments { mean, std, min, max } = Moments::of(samples)?;
        let [p05, p95] = percentiles(samples, [0.05, 0.95]);
        let drift = Drift::of(samples);
        Some(Self {
            mean,
            std,
            min,
            max,
            p05,
            p95,
            std_error: standard_error(samples),
            drift: drift.change,
            drifts: drift.exceeds(SIGNIFICANT, MATTERS * scale),
        })
    }

    /// The value below which the fraction `part` of the samples is found, from 0 to 1, interpolated
    /// linearly between order statistics; none of an empty slice.
    pub fn percentile(samples: &[f64], part: f64) -> Option<f64> {
        let mut shuffled = samples.to_vec();
        (!samples.is_empty()).then(|| percentile(&mut shuffled, part))
    }
}

/// Two percentiles of samples, at least one, which may be too many for memory.
fn percentiles(samples: &(impl Samples + ?Sized), parts: [f64; 2]) -> [f64; 2] {
    let last = samples.count() - 1;
    let places = parts.map(|part| part * last as f64);
    let [low, high] = places.map(|place| place.floor() as usize);
    let [low_next, high_next] = [low, high].map(|place| (place + 1).min(last));
    let found = sorted_at(samples, [low, low_next, high, high_next]);
    let between = |place: f64, at: f64, next: f64| at + (place - place.floor()) * (next - at);
    [between(places[0], found[0], found[1]), between(places[1], found[2], found[3])]
}

/// A percentile of samples, at least one, interpolated linearly between order statistics. The
/// samples are partially sorted until these are at their final positions, which takes a quarter of
/// the time of sorting.
pub(in crate::dynamics) fn percentile<T: Copy + Into<f64>>(samples: &mut [T], part: f64) -> f64 {
    let order = |a: &T, b: &T| (*a).into().total_cmp(&(*b).into());
    let place = part * (samples.len() - 1) as f64;
    let low = place.floor();
    let (_, at, above) = samples.select_nth_unstable_by(low as usize, order);
    let at: f64 = (*at).into();
    let next = above.iter().min_by(|a, b| order(a, b));
    at + (place - low) * (next.map_or(at, |next| (*next).into()) - at)
}

// The scalars that vary over a run, and the scales on which their drifts are measured.

/// A scalar that varies.
pub struct Varying<'a> {
    pub samples: &'a [f64],
    pub scale: DriftScale,
}

/// The scalars that vary, with their samples, as the columns against time declare them.
pub fn varying(series: &TimeSeries) -> [Varying<'_>; VARYING.len()] {
    VARYING.map(|column| Varying {
        samples: (column.of)(series).kept().expect("a column without gaps has statistics"),
        scale: column.statistics.expect("those that vary have statistics").scale,
    })
}

/// A scalar that varies over a run that may be too long for memory.
pub struct VaryingHistory<'a> {
    pub name: &'static str,
    pub samples: ScalarHistory<'a>,
    pub scale: DriftScale,
}

/// The scalars that vary, from a row of the history on.
pub fn varying_from(history: History<'_>, from: usize) -> [VaryingHistory<'_>; VARYING.len()] {
    VARYING.map(|column| VaryingHistory {
        name: column.quantity.name,
        samples: history.scalar(column, from),
        scale: column.statistics.expect("those that vary have statistics").scale,
    })
}

/// The scales on which drifts are measured, of scalars with these means. Forces along the string go
/// by the largest of them and by 10 kN at least, torques by the largest and by 1 kN·m: half a
/// percent of less than that is nothing that a rig shows.
pub fn scales<const N: usize>(means: [(DriftScale, f64); N]) -> [f64; N] {
    let largest = |kind: DriftScale, least: f64| {
        let alike = means.iter().filter(|(scale, _)| *scale == kind);
        alike.fold(least, |most, (_, mean)| most.max(mean.abs()))
    };
    let (force_N, torque_N_m) = (largest(DriftScale::Force, 1e4), largest(DriftScale::Torque, 1e3));
    means.map(|(scale, mean)| match scale {
        DriftScale::Force => force_N,
        DriftScale::Torque => torque_N_m,
        DriftScale::Own(least) => mean.abs().max(least),
    })
}
