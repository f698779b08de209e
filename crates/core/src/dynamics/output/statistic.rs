//! The distribution of a quantity over the window.

use serde::{Deserialize, Serialize};

use super::drift::{Drift, MATTERS, SIGNIFICANT, mean, standard_error};

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

    /// The value below which that part of the samples lies, from 0 to 1, interpolated linearly
    /// between order statistics; none of an empty slice.
    pub fn percentile(samples: &[f64], part: f64) -> Option<f64> {
        let mut shuffled = samples.to_vec();
        (!samples.is_empty()).then(|| percentile(&mut shuffled, part))
    }
}

/// A percentile of samples, at least one, interpolated linearly between order statistics. The
/// samples are shuffled until these stand where they would if all were sorted, which takes a
/// quarter of the time of sorting.
pub(in crate::dynamics) fn percentile<T: Copy + Into<f64>>(samples: &mut [T], part: f64) -> f64 {
    let order = |a: &T, b: &T| (*a).into().total_cmp(&(*b).into());
    let place = part * (samples.len() - 1) as f64;
    let low = place.floor();
    let (_, at, above) = samples.select_nth_unstable_by(low as usize, order);
    let at: f64 = (*at).into();
    let next = above.iter().min_by(|a, b| order(a, b));
    at + (place - low) * (next.map_or(at, |next| (*next).into()) - at)
}
