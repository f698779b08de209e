//! The window of a dynamic run's statistics.

use std::ops::Range;

use crate::dynamics::{DynamicOutcome, Statistic, TimeSeries};

/// The window of a run, with at least one sample.
pub struct Window<'a> {
    outcome: &'a DynamicOutcome,
    rows: Range<usize>,
}

impl<'a> Window<'a> {
    /// The rows from where it begins; none where there are none.
    pub fn of(outcome: &'a DynamicOutcome) -> Option<Self> {
        let from_s = outcome.numerics.settle_s;
        let time_s = &outcome.series.time_s;
        let rows = time_s.partition_point(|time| *time < from_s)..time_s.len();
        let unsampled = outcome.statistics.is_empty();
        (!unsampled && !rows.is_empty()).then_some(Self { outcome, rows })
    }

    /// The statistic of a quantity of [`DynamicOutcome::quantities`].
    pub fn statistic(&self, name: &str) -> Option<&Statistic> {
        self.outcome.statistic(name)
    }

    /// Mean and largest value of a quantity; zeros of one that is not known.
    pub fn mean_and_max(&self, name: &str) -> [f64; 2] {
        let of = self.statistic(name);
        of.map_or([0.0; 2], |of| [of.mean, of.max])
    }

    /// Magnitudes of the surface torque, N·m: of its mean and the largest.
    pub fn torque_N_m(&self) -> [f64; 2] {
        let of = self.statistic("surface_torque_N_m");
        of.map_or([0.0; 2], |of| [of.mean.abs(), of.max.max(-of.min)])
    }

    /// Mean and largest of the pressures that the pump delivers at, Pa; none without a rheology.
    pub fn pump_pressure_Pa(&self) -> Option<[f64; 2]> {
        let samples: Vec<f64> =
            self.series(|of| &of.pump_pressure_Pa).iter().flatten().copied().collect();
        let largest_Pa = samples.iter().copied().reduce(f64::max)?;
        Some([mean(&samples), largest_Pa])
    }

    /// A scalar of the run over the window.
    pub fn series<T>(&self, of: fn(&TimeSeries) -> &Vec<T>) -> &'a [T] {
        let values = of(&self.outcome.series);
        &values[self.rows.start.min(values.len())..]
    }

    /// Time from its first to its last sample, s.
    pub fn length_s(&self) -> f64 {
        match self.series(|of| &of.time_s) {
            [first, .., last] => last - first,
            _ => 0.0,
        }
    }
}

/// Mean of samples; zero of none.
pub fn mean(samples: &[f64]) -> f64 {
    samples.iter().sum::<f64>() / samples.len().max(1) as f64
}

/// The share of samples that are so; zero of none.
pub fn share<T>(samples: &[T], is: impl Fn(&T) -> bool) -> f64 {
    let count = samples.iter().filter(|of| is(of)).count();
    count as f64 / samples.len().max(1) as f64
}
