//! A dynamic run in hand.

use std::{
    sync::{Mutex, MutexGuard, PoisonError},
    thread::{self, ThreadId},
};

use pyo3::{prelude::*, types::PyBytes};
use wholestring::{
    dynamics::{FRAME, HoistSetPoint, ScheduleStep},
    outcome::{Column as Declared, TIME_SERIES, Values},
};
use wholestring_results::{Column, Data, Table as StoredTable};
use wholestring_runner::{CancellationToken, Error, Observer, run::Live};

use crate::{
    answers::Answers,
    attended::{attended, attended_here},
    error,
    law::Raised,
    table::Table,
};

/// A dynamic run that Python takes forward.
#[pyclass(frozen, module = "wholestring._core")]
pub(crate) struct Simulation {
    live: Mutex<Live>,
    /// The thread that takes it forward now, which waits for what its laws answer.
    advances: Mutex<Option<ThreadId>>,
    /// What its laws raised.
    raised: Raised,
}

/// Says that nobody takes the run forward any more, however that ended.
struct Advancing<'a>(&'a Simulation);

impl<'a> Advancing<'a> {
    fn new(of: &'a Simulation) -> Self {
        *of.advancing() = Some(thread::current().id());
        Self(of)
    }
}

impl Drop for Advancing<'_> {
    fn drop(&mut self) {
        *self.0.advancing() = None;
    }
}

impl Simulation {
    pub(crate) fn new(live: Live, raised: Raised) -> Self {
        Self { live: Mutex::new(live), advances: Mutex::default(), raised }
    }

    fn advancing(&self) -> MutexGuard<'_, Option<ThreadId>> {
        self.advances.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn live(&self) -> MutexGuard<'_, Live> {
        // Whoever panicked with it has said so.
        self.live.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Asks the run; refuses a law that asks the run that waits for its answer.
    pub(crate) fn asked<T: Send>(
        &self,
        py: Python<'_>,
        of: impl FnOnce(&mut Live) -> T + Send,
    ) -> PyResult<T> {
        if *self.advancing() == Some(thread::current().id()) {
            let message = "a law of one's own asks the simulation that waits for its answer";
            return Err(error::of_work(py, &Error::BadInput(message.to_owned())));
        }
        Ok(py.detach(|| of(&mut self.live())))
    }
}

/// Columns of rows from one on, as a table has them.
fn columns<T>(declared: &'static [Declared<T>], of: &T, row: usize) -> Vec<Column> {
    let columns = declared.iter().filter_map(|column| match (column.rows_from)(of, row) {
        Values::Numbers(numbers) => {
            let number = |of: &f64| of.is_finite().then_some(*of);
            Some(Column {
                name: column.quantity.name.into(),
                unit: column.quantity.unit.into(),
                meaning: column.quantity.meaning.into(),
                data: Data::Number(numbers.iter().map(number).collect()),
            })
        }
        Values::Words(_) => None,
    });
    columns.collect()
}

#[pymethods]
impl Simulation {
    /// Advances by so many seconds.
    fn advance(&self, py: Python<'_>, seconds: f64, listener: &Bound<'_, PyAny>) -> PyResult<()> {
        // Refused before a thread waits for it.
        let on_rock = self.asked(py, |live| live.is_on_rock())?;
        let advance = |observer: &dyn Observer, cancellation: &CancellationToken| {
            let mut live = self.live();
            let _advancing = Advancing::new(self);
            live.advance(seconds, observer, cancellation)
        };
        // On rock a sample may take longer than an interrupt waits.
        let work = if on_rock {
            attended(py, listener, advance)?
        } else {
            attended_here(py, listener, advance)
        };
        match (work.raised.or(self.raised.take()), work.result) {
            (Some(raised), _) => Err(raised),
            (None, result) => result.map_err(|error| error::of_work(py, &error)),
        }
    }

    /// Sets set points from now on, within `ramp_s`.
    #[pyo3(signature = (
        ramp_s, rotary_speed_rad_per_s, block_velocity_m_per_s, weight_on_bit_N, flow_rate_m3_per_s
    ))]
    fn set(
        &self,
        py: Python<'_>,
        ramp_s: f64,
        rotary_speed_rad_per_s: Option<f64>,
        block_velocity_m_per_s: Option<f64>,
        weight_on_bit_N: Option<f64>,
        flow_rate_m3_per_s: Option<f64>,
    ) -> PyResult<()> {
        let velocity = block_velocity_m_per_s.map(HoistSetPoint::BlockVelocity);
        let hoist = velocity.or(weight_on_bit_N.map(HoistSetPoint::WeightOnBit));
        let line = ScheduleStep {
            at_s: 0.0,
            ramp_s,
            rotary_speed_rad_per_s,
            hoist,
            flow_rate_m3_per_s,
            note: None,
        };
        let added = self.asked(py, |live| live.add_to_schedule(line))?;
        added.map_err(|error| error::of_work(py, &error))
    }

    /// Sets the kinetic coefficient of friction of the hole, or of each of its sections, within
    /// `ramp_s`.
    fn set_friction(&self, py: Python<'_>, ramp_s: f64, kinetic: Vec<f64>) -> PyResult<()> {
        let set = self.asked(py, |live| live.set_friction(&kinetic, ramp_s))?;
        set.map_err(|error| error::of_work(py, &error))
    }

    /// The kinetic coefficient of friction of each section of the hole now.
    fn friction(&self, py: Python<'_>) -> PyResult<Vec<f64>> {
        self.asked(py, |live| live.simulation().friction())
    }

    /// Time, end, sample interval, all in s, and whether it settles.
    fn clock(&self, py: Python<'_>) -> PyResult<(f64, f64, f64, bool)> {
        self.asked(py, |live| {
            let of = live.simulation();
            (of.time_s(), of.end_time_s(), of.sample_interval_s(), of.is_settling())
        })
    }

    /// The last sample, by the names of the columns of the table against time; nothing before the
    /// first, NaN where a column has no value.
    fn last(&self, py: Python<'_>) -> PyResult<Vec<(&'static str, f64)>> {
        self.asked(py, |live| {
            let series = live.simulation().series();
            let row = series.time_s.len().saturating_sub(1);
            let last = |column: &Declared<_>| match (column.rows_from)(series, row) {
                Values::Numbers(numbers) => Some((column.quantity.name, *numbers.last()?)),
                Values::Words(_) => None,
            };
            TIME_SERIES.iter().filter_map(last).collect()
        })
    }

    /// The samples after a time, s.
    fn samples(&self, py: Python<'_>, after_s: f64) -> PyResult<Table> {
        let columns = self.asked(py, |live| {
            let series = live.simulation().series();
            let row = series.time_s.partition_point(|time_s| *time_s <= after_s);
            columns(TIME_SERIES, series, row)
        })?;
        Table::of(&StoredTable::new(columns))
    }

    /// Drops the samples of before a time, s.
    fn forget(&self, py: Python<'_>, before_s: f64) -> PyResult<()> {
        self.asked(py, |live| live.forget(before_s))
    }

    /// The whole string as it is now.
    fn state(&self, py: Python<'_>) -> PyResult<Table> {
        let columns = self.asked(py, |live| columns(FRAME, &live.simulation().frame(), 0))?;
        Table::of(&StoredTable::new(columns))
    }

    /// The answers so far.
    fn answers(&self, py: Python<'_>) -> PyResult<Answers> {
        Ok(self.asked(py, |live| live.answers())?.into())
    }

    /// All of it, as bytes.
    fn checkpoint<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        let bytes = self.asked(py, |live| live.checkpoint())?;
        let bytes = bytes.map_err(|error| error::of_work(py, &error))?;
        Ok(PyBytes::new(py, &bytes))
    }

    /// Name of the operation.
    #[getter]
    fn operation(&self, py: Python<'_>) -> PyResult<&'static str> {
        self.asked(py, |live| live.operation().kind.name())
    }
}
