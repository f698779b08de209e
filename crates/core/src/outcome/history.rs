//! The scalars of a run against time as a whole: the rows that were handed over, and those that are
//! in memory.

use std::fmt;

use super::{
    column::{Column, Values},
    samples::Samples,
    time_series::{TIME_SERIES, TimeSeries},
};

/// Rows of a run's series that were handed over
/// ([`Simulation::hand_over`](crate::dynamics::Simulation::hand_over)) and are kept elsewhere: in a
/// file, from which they are read as often as they are needed.
pub trait EarlierRows: fmt::Debug + Sync {
    /// Number of rows.
    fn rows(&self) -> usize;

    /// Calls `take` with the numbers of these columns from a row on, stretch after stretch, all
    /// columns of one length: one slice for each column; not a number where there is none. Rows
    /// that cannot be read are such, too: whoever keeps them knows of the fault.
    fn each(&self, columns: &[&'static str], from: usize, take: &mut dyn FnMut(&[&[f64]]));
}

/// The scalars of a run against time.
#[derive(Debug, Clone, Copy)]
pub struct History<'a> {
    earlier: Option<&'a dyn EarlierRows>,
    series: &'a TimeSeries,
}

impl<'a> History<'a> {
    /// Of the rows in memory and those before them, if there are any.
    pub fn new(earlier: Option<&'a dyn EarlierRows>, series: &'a TimeSeries) -> Self {
        Self { earlier, series }
    }

    /// The rows in memory.
    pub fn series(&self) -> &'a TimeSeries {
        self.series
    }

    fn earlier_rows(&self) -> usize {
        self.earlier.map_or(0, EarlierRows::rows)
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.earlier_rows() + self.series.time_s.len()
    }

    /// The first row that is not before a time, s.
    pub fn row_at(&self, time_s: f64) -> usize {
        let is_before = |time: &f64| *time < time_s;
        let mut rows = 0;
        self.scalar(TIME, 0).each(&mut |times| rows += times.partition_point(is_before));
        rows
    }

    /// Calls `take` with the numbers of columns from a row on, stretch after stretch: one slice for
    /// each column; not a number where a column has none.
    pub fn each(
        &self,
        columns: &[&'static Column<TimeSeries>],
        from: usize,
        take: &mut dyn FnMut(&[&[f64]]),
    ) {
        let earlier_rows = self.earlier_rows();
        if let Some(earlier) = self.earlier.filter(|_| from < earlier_rows) {
            let names: Vec<&str> = columns.iter().map(|column| column.quantity.name).collect();
            earlier.each(&names, from, take);
        }
        let from = from.saturating_sub(earlier_rows);
        let values: Vec<Values<'_>> =
            columns.iter().map(|column| (column.rows_from)(self.series, from)).collect();
        let numbers: Vec<&[f64]> = values.iter().map(Values::numbers).collect();
        take(&numbers);
    }

    /// A scalar from a row on.
    pub fn scalar(self, column: &'static Column<TimeSeries>, from: usize) -> ScalarHistory<'a> {
        ScalarHistory { history: self, column, from }
    }
}

const TIME: &Column<TimeSeries> = Column::named(TIME_SERIES, "time_s");

/// A scalar of a run against time, from a row on.
#[derive(Debug, Clone, Copy)]
pub struct ScalarHistory<'a> {
    history: History<'a>,
    column: &'static Column<TimeSeries>,
    from: usize,
}

impl Samples for ScalarHistory<'_> {
    fn count(&self) -> usize {
        self.history.rows().saturating_sub(self.from)
    }

    fn each(&self, take: &mut dyn FnMut(&[f64])) {
        self.history.each(&[self.column], self.from, &mut |columns| take(columns[0]));
    }
}
