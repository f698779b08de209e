//! Settling of a run before its window: for a given time, or until the string is steady.

use crate::{
    dynamics::{
        assemble::chain,
        output::{
            drift::{Drift, MATTERS, SIGNIFICANT},
            statistic::{scales, varying},
        },
        settings::{DynamicsSettings, Start},
    },
    model::Model,
    operation::Operation,
    outcome::{SCALARS, TimeSeries, VARYING, samples::mean},
    rod::{mesh::Mesh, torsion},
    statics::soft::{self, SoftSettings},
};

/// Time over which the extra damping of a prepared start fades, s: earlier samples do not describe
/// the string without it.
pub(in crate::dynamics) const FADING_S: f64 = 5.0;

/// Shortest stretch that is tested, s.
const MIN_INTERVAL_S: f64 = 5.0;

/// Revolutions of the string in the stretch, and the most time that they may take, s.
const REVOLUTIONS: f64 = 3.0;
const REVOLUTIONS_MAX_S: f64 = 30.0;

/// Periods of the lowest torsional motion in the stretch. Stick-slip is as slow as that or a little
/// slower.
const TORSIONAL_PERIODS: f64 = 2.0;

/// Samples of the stretch at least: sixteen blocks of four in either half.
const MIN_SAMPLES: f64 = 128.0;

/// Time between two tests, s.
const TEST_INTERVAL_S: f64 = 1.0;

/// Remaining fraction of the drift that matters in a window when it opens.
const LEFT: f64 = 0.2;

/// Standard errors beyond which a change of the spread is no chance. The magnitude of a swing's
/// deviation swings, too, which makes its standard error large; to wait a second too long costs
/// little.
const SPREAD_SIGNIFICANT: f64 = 2.0;

/// Allowed change of a steady travelling string in addition to the soft string's prediction: the
/// fraction of its length that it travels, of each scale, for effects that the soft string does not
/// model, such as joints that pass a place where the hole begins to bend.
const TRAVEL: f64 = 1.0;

/// Distance over which the soft string predicts the effect of travel, m.
const FORETOLD_OVER_M: f64 = 2.0;

/// Travel of a travelling string, m, and its minimum settling time, s: its place in the hole is
/// chosen before that is known.
const TRAVELS_M: f64 = 1.0;
const TRAVELS_MIN_S: f64 = 30.0;

/// When the window opens.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::dynamics) enum Settling {
    /// After a given time, s.
    Fixed(f64),
    /// As soon as the string is steady.
    UntilSteady {
        /// Length of the stretch that is tested, s.
        stretch_s: f64,
        /// Time of the first test, s.
        min_s: f64,
        /// Time at which the window opens regardless of the test, s.
        max_s: f64,
        /// Change of each varying scalar per metre that the bit moves down the hole, in a string
        /// that travels; SI.
        per_metre: [f64; VARYING.len()],
    },
}

/// End of the settling, where it was to end by itself.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub(in crate::dynamics) struct Settled {
    /// Time of the first sample of the window, s.
    pub(in crate::dynamics) settle_s: f64,
    /// Whether the string was steady then.
    pub(in crate::dynamics) steady: bool,
}

impl Settling {
    /// The settling that the settings require.
    ///
    /// A stretch holds three revolutions and two periods of the lowest torsional motion, and five
    /// seconds at least. It begins when the extra damping or the ramp of the start is over and the
    /// schedule's last line is done. A string that travels by more than a metre settles for 30 s at
    /// least, so that it mostly is where it was meant to be in the middle of the window.
    pub(in crate::dynamics) fn of(
        model: &Model,
        operation: &Operation,
        settings: &DynamicsSettings,
        mesh: &Mesh,
    ) -> Self {
        let Some(until) = settings.steady else {
            return Self::Fixed(settings.settle_s);
        };
        let spin = operation.rotation_rad_per_s().abs();
        let turning_s = if spin > 0.0 {
            (REVOLUTIONS * std::f64::consts::TAU / spin).min(REVOLUTIONS_MAX_S)
        } else {
            0.0
        };
        let stretch_s = MIN_INTERVAL_S
            .max(turning_s)
            .max(TORSIONAL_PERIODS / torsion::lowest_frequency_Hz(mesh))
            .max(MIN_SAMPLES * settings.sample_interval_s);
        let start_s = match settings.start {
            Start::Prepared => FADING_S,
            Start::Centred => settings.centred.ramp_s,
        };
        let planned_s = settings.schedule.end_s();
        let travel_m = chain::hoisting(operation, settings).1.abs() * until.max_s;
        let travels = travel_m > TRAVELS_M && !settings.schedule.moves_the_hoist();
        let min_s = settings.settle_s.max(start_s).max(planned_s) + stretch_s;
        let min_s = if travels { min_s.max(TRAVELS_MIN_S) } else { min_s };
        let max_s = (planned_s + until.max_s).max(min_s);
        let per_metre = if travels { per_metre(model, operation) } else { [0.0; VARYING.len()] };
        Self::UntilSteady { stretch_s, min_s, max_s, per_metre }
    }

    /// The shortest time before the window, s.
    pub(in crate::dynamics) fn min_s(&self) -> f64 {
        match *self {
            Self::Fixed(settle_s) => settle_s,
            Self::UntilSteady { min_s, .. } => min_s,
        }
    }

    /// The longest, s.
    pub(in crate::dynamics) fn max_s(&self) -> f64 {
        match *self {
            Self::Fixed(settle_s) => settle_s,
            Self::UntilSteady { max_s, .. } => max_s,
        }
    }

    /// Maximum number of the last samples, every `interval_s`, that the next test needs.
    pub(in crate::dynamics) fn needed_samples(&self, interval_s: f64) -> usize {
        match *self {
            Self::Fixed(_) => 1,
            Self::UntilSteady { stretch_s, .. } => (stretch_s / interval_s).ceil() as usize + 1,
        }
    }

    /// Whether the samples so far, every `interval_s`, end the settling before a window of
    /// `duration_s`; a fixed time never does. It depends on the samples alone, so that a run that
    /// was resumed ends it at the same one.
    pub(in crate::dynamics) fn ends(
        &self,
        series: &TimeSeries,
        interval_s: f64,
        duration_s: f64,
        length_m: f64,
    ) -> Option<Settled> {
        let Self::UntilSteady { stretch_s, min_s, max_s, ref per_metre } = *self else {
            return None;
        };
        let samples = |time_s: f64| (time_s / interval_s).round().max(1.0) as usize;
        let now = series.time_s.last().map_or(0, |time_s| samples(*time_s));
        let settle_s = (now + 1) as f64 * interval_s;
        let (least, most) = (samples(min_s), samples(max_s));
        let due =
            now >= most || now >= least && (now - least).is_multiple_of(samples(TEST_INTERVAL_S));
        if !due {
            return None;
        }
        let from = series.time_s.len().saturating_sub(samples(stretch_s));
        let of_window = (stretch_s / duration_s).min(1.0);
        let steady = is_steady(series, from, of_window, per_metre, length_m);
        (steady || now >= most).then_some(Settled { settle_s, steady })
    }
}

/// Change of each varying scalar per metre that the bit moves down the hole, for a string of
/// unchanged length, by the soft string. Zero for scalars that the soft string does not model, and
/// where it has no solution: a drift then counts in full.
fn per_metre(model: &Model, operation: &Operation) -> [f64; VARYING.len()] {
    let at = |down_m| soft::scalars_at(model, operation, &SoftSettings::default(), down_m).ok();
    let ends = [-0.5, 0.5].map(|part| at(part * FORETOLD_OVER_M));
    let [Some(above), Some(below)] = ends else {
        return [0.0; VARYING.len()];
    };
    VARYING.map(|column| {
        let scalar = SCALARS.iter().find(|scalar| scalar.quantity.name == column.quantity.name);
        let change = scalar.and_then(|scalar| Some((scalar.of)(&below)? - (scalar.of)(&above)?));
        change.unwrap_or(0.0) / FORETOLD_OVER_M
    })
}

/// Whether the samples from row `from` on drift by less than a fifth of what matters, in their
/// means and in their spread, so that a window that is longer than they, of which they are the part
/// `of_window`, would drift by less, too. The change with the bit's travel, `per_metre`, is no
/// drift, and a travelling string may change in addition by the fraction of its length that it
/// travels, of each scale.
fn is_steady(
    series: &TimeSeries,
    from: usize,
    of_window: f64,
    per_metre: &[f64; VARYING.len()],
    length_m: f64,
) -> bool {
    let scalars = varying(series).map(|scalar| (scalar.samples.get(from..).unwrap_or(&[]), scalar));
    let scales = scales(scalars.each_ref().map(|(samples, scalar)| (scalar.scale, mean(*samples))));
    let bit_m = series.bit_depth_m.get(from..).unwrap_or(&[]);
    let travel_m = match bit_m {
        [first, .., last] => (last - first).abs(),
        _ => 0.0,
    };
    let least = LEFT * MATTERS * of_window + TRAVEL * travel_m / length_m;
    scalars.iter().zip(scales).zip(per_metre).all(|(((samples, _), scale), per_metre)| {
        let travelled = samples.iter().zip(bit_m);
        let samples: Vec<f64> =
            travelled.map(|(x, md_m)| x - per_metre * (md_m - bit_m[0])).collect();
        let mean = mean(&samples);
        let spread: Vec<f64> = samples.iter().map(|x| (x - mean).abs()).collect();
        !Drift::of(&samples).exceeds(SIGNIFICANT, least * scale)
            && !Drift::of(&spread).exceeds(SPREAD_SIGNIFICANT, least * scale)
    })
}

#[cfg(test)]
mod tests;
