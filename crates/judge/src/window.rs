//! The window of a dynamic run's statistics.

use std::ops::Range;

use wholestring::{
    dynamics::Statistic,
    outcome::{InTime, Solution, TimeSeries},
};

/// The window of a run, with at least one sample.
pub struct Window<'a> {
    run: &'a InTime<'a>,
    rows: Range<usize>,
}

impl<'a> Window<'a> {
    /// The rows from the beginning of the window; none where there are none.
    pub fn of(run: &'a InTime<'a>) -> Option<Self> {
        let from_s = run.numerics.settle_s;
        let time_s = &run.series.time_s;
        let rows = time_s.partition_point(|time| *time < from_s)..time_s.len();
        let unsampled = run.statistics.is_empty();
        (!unsampled && !rows.is_empty()).then_some(Self { run, rows })
    }

    /// The window of a solution in time.
    pub fn of_solution(solution: &'a Solution<'a>) -> Option<Self> {
        Self::of(solution.in_time.as_ref()?)
    }

    /// The run.
    pub fn run(&self) -> &'a InTime<'a> {
        self.run
    }

    /// The statistic of a quantity by its name.
    pub fn statistic(&self, name: &str) -> Option<&'a Statistic> {
        let mut statistics = self.run.statistics.iter();
        statistics.find(|(quantity, _)| *quantity == name).map(|(_, statistic)| statistic)
    }

    /// Largest magnitude of the surface torque, N·m.
    pub fn largest_torque_N_m(&self) -> f64 {
        let statistic = self.statistic("surface_torque_N_m");
        statistic.map_or(0.0, |statistic| statistic.max.max(-statistic.min))
    }

    /// Largest pressure that the pump delivers at, Pa; none without a rheology.
    pub fn largest_pump_pressure_Pa(&self) -> Option<f64> {
        let samples = self.series(|series| &series.pump_pressure_Pa).iter().flatten();
        samples.copied().reduce(f64::max)
    }

    /// A scalar of the run over the window.
    pub fn series<T>(&self, column: fn(&TimeSeries) -> &Vec<T>) -> &'a [T] {
        let values = column(self.run.series);
        &values[self.rows.start.min(values.len())..]
    }

    /// Time from its first to its last sample, s.
    pub fn length_s(&self) -> f64 {
        match self.series(|series| &series.time_s) {
            [first, .., last] => last - first,
            _ => 0.0,
        }
    }
}

/// Mean of samples; zero of none.
pub fn mean(samples: &[f64]) -> f64 {
    samples.iter().sum::<f64>() / samples.len().max(1) as f64
}

/// The share of samples for which a condition holds; zero of none.
pub fn share<T>(samples: &[T], holds: impl Fn(&T) -> bool) -> f64 {
    let count = samples.iter().filter(|sample| holds(sample)).count();
    count as f64 / samples.len().max(1) as f64
}
