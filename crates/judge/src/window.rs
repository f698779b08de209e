//! The window of a dynamic run's statistics.

use wholestring::{
    dynamics::Statistic,
    outcome::{
        Column, InTime, Samples, ScalarHistory, Solution, TIME_SERIES, TimeSeries,
        samples::{ends, sum},
    },
};

/// The window of a run, with at least one sample.
pub struct Window<'a> {
    run: &'a InTime<'a>,
    /// The first row of the history in the window.
    from: usize,
}

impl<'a> Window<'a> {
    /// The rows from the beginning of the window; `None` where there are none.
    pub fn of(run: &'a InTime<'a>) -> Option<Self> {
        if run.statistics.is_empty() {
            return None;
        }
        let from = run.history.row_at(run.numerics.settle_s);
        (from < run.history.rows()).then_some(Self { run, from })
    }

    /// The window of a dynamic run's solution.
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

    /// Largest discharge pressure of the pump, Pa; `None` without a rheology.
    pub fn largest_pump_pressure_Pa(&self) -> Option<f64> {
        let mut largest_Pa: Option<f64> = None;
        self.scalar(PUMP_PRESSURE).each(&mut |pressures_Pa| {
            let known_Pa = pressures_Pa.iter().copied().filter(|pressure_Pa| !pressure_Pa.is_nan());
            largest_Pa = largest_Pa.into_iter().chain(known_Pa).reduce(f64::max);
        });
        largest_Pa
    }

    /// A scalar of the run over the window; not a number where it has none.
    pub fn scalar(&self, column: &'static Column<TimeSeries>) -> ScalarHistory<'a> {
        self.run.history.scalar(column, self.from)
    }

    /// The share of the rows that count for which a condition on two scalars holds; zero without
    /// rows.
    pub fn share_of(
        &self,
        columns: [&'static Column<TimeSeries>; 2],
        counts: impl Fn([f64; 2]) -> bool,
        holds: impl Fn([f64; 2]) -> bool,
    ) -> f64 {
        let (mut counted, mut held) = (0_usize, 0_usize);
        self.run.history.each(&columns, self.from, &mut |columns| {
            for (first, second) in columns[0].iter().zip(columns[1]) {
                if counts([*first, *second]) {
                    counted += 1;
                    held += usize::from(holds([*first, *second]));
                }
            }
        });
        held as f64 / counted.max(1) as f64
    }

    /// Time from its first to its last sample, s.
    pub fn length_s(&self) -> f64 {
        ends(&self.scalar(TIME)).map_or(0.0, |[first_s, last_s]| last_s - first_s)
    }
}

const TIME: &Column<TimeSeries> = Column::named(TIME_SERIES, "time_s");
const PUMP_PRESSURE: &Column<TimeSeries> = Column::named(TIME_SERIES, "pump_pressure_Pa");

/// The share of samples for which a condition holds; zero without samples.
pub fn share(samples: &impl Samples, holds: impl Fn(f64) -> bool) -> f64 {
    let count = sum(samples, |_, sample| f64::from(u8::from(holds(sample))));
    count / samples.count().max(1) as f64
}
