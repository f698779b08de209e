//! How long a run settles before its window: a given time, or until the string is steady.

use crate::{
    dynamics::{
        assemble::hoisting,
        output::{
            drift::{Drift, MATTERS, SIGNIFICANT, mean},
            varying::{scales, varying},
        },
        settings::{DynamicsSettings, Start},
    },
    operation::Operation,
    outcome::TimeSeries,
    rod::{mesh::Mesh, torsion},
};

/// Time over which the extra damping of a prepared start fades, s: what comes before says nothing
/// of the string without it.
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

/// Part of what matters in a window that may be left when it opens.
const LEFT: f64 = 0.2;

/// Standard errors beyond which a change of the spread is no chance. The magnitude of a swing's
/// deviation swings, too, which makes its standard error large; to wait a second too long costs
/// little.
const SPREAD_SIGNIFICANT: f64 = 2.0;

/// By how much more than in proportion to the length of the string a string that travels may
/// change, when it is steady: what a build holds leaves it several times as fast, and the stretch
/// of a string whose drag takes most of its weight was found to change nine times as fast.
const TRAVEL: f64 = 10.0;

/// A string that travels, and what it settles at least, s: its place in the hole is chosen before
/// that is known.
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
        /// Time at which it opens whatever the test says, s.
        max_s: f64,
    },
}

/// How settling ended, where it was to end by itself.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub(in crate::dynamics) struct Settled {
    /// Time of the first sample of the window, s.
    pub(in crate::dynamics) settle_s: f64,
    /// Whether the string was steady then.
    pub(in crate::dynamics) steady: bool,
}

impl Settling {
    /// What the settings ask for.
    ///
    /// A stretch holds three revolutions and two periods of the lowest torsional motion, and five
    /// seconds at least. It begins when the extra damping or the ramp of the start is over and the
    /// schedule's last line is done. A string that travels by more than a metre settles for 30 s at
    /// least, so that it mostly is where it was meant to be in the middle of the window.
    pub(in crate::dynamics) fn of(
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
        let travel_m = hoisting::hoisting(operation, settings).1.abs() * until.max_s;
        let travels = travel_m > TRAVELS_M && !settings.schedule.moves_the_hoist();
        let min_s = settings.settle_s.max(start_s).max(planned_s) + stretch_s;
        let min_s = if travels { min_s.max(TRAVELS_MIN_S) } else { min_s };
        Self::UntilSteady { stretch_s, min_s, max_s: (planned_s + until.max_s).max(min_s) }
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

    /// Whether what was sampled so far, every `interval_s`, ends the settling before a window of
    /// `duration_s`; a fixed time never does. It depends on the samples alone, so that a run that
    /// was resumed ends it at the same one.
    pub(in crate::dynamics) fn ends(
        &self,
        series: &TimeSeries,
        interval_s: f64,
        duration_s: f64,
        length_m: f64,
    ) -> Option<Settled> {
        let Self::UntilSteady { stretch_s, min_s, max_s } = *self else {
            return None;
        };
        let samples = |time_s: f64| (time_s / interval_s).round().max(1.0) as usize;
        let now = series.time_s.len();
        let settle_s = (now + 1) as f64 * interval_s;
        let (least, most) = (samples(min_s), samples(max_s));
        let due =
            now >= most || now >= least && (now - least).is_multiple_of(samples(TEST_INTERVAL_S));
        if !due {
            return None;
        }
        let from = now.saturating_sub(samples(stretch_s));
        let steady = is_steady(series, from, (stretch_s / duration_s).min(1.0), length_m);
        (steady || now >= most).then_some(Settled { settle_s, steady })
    }
}

/// Whether the samples from row `from` on drift by less than a fifth of what matters, in their
/// means and in their spread, so that a window that is longer than they, of which they are the part
/// `of_window`, would drift by less, too. A string that travels may change besides: by ten times
/// the part of its length that it travels, of each scale.
fn is_steady(series: &TimeSeries, from: usize, of_window: f64, length_m: f64) -> bool {
    let scalars = varying(series).map(|scalar| (scalar.samples.get(from..).unwrap_or(&[]), scalar));
    let scales = scales(scalars.each_ref().map(|(samples, scalar)| (scalar.scale, mean(samples))));
    let bit_m = series.bit_depth_m.get(from..).unwrap_or(&[]);
    let travel_m = match bit_m {
        [first, .., last] => (last - first).abs(),
        _ => 0.0,
    };
    let least = LEFT * MATTERS * of_window + TRAVEL * travel_m / length_m;
    scalars.iter().zip(scales).all(|((samples, _), scale)| {
        let mean = mean(samples);
        let spread: Vec<f64> = samples.iter().map(|x| (x - mean).abs()).collect();
        !Drift::of(samples).exceeds(SIGNIFICANT, least * scale)
            && !Drift::of(&spread).exceeds(SPREAD_SIGNIFICANT, least * scale)
    })
}

#[cfg(test)]
mod tests;
