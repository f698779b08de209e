//! A dynamic run controlled from Python.

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

/// A dynamic run that Python advances.
#[pyclass(frozen, module = "wholestring._core")]
pub(crate) struct Simulation {
    live: Mutex<Live>,
    /// The thread that advances it at present, which waits for the values of its laws.
    advances: Mutex<Option<ThreadId>>,
    /// Exceptions of its laws.
    raised: Raised,
}

/// Marks the run as no longer being advanced, however that ended.
struct Advancing<'a>(&'a Simulation);

impl<'a> Advancing<'a> {
    fn new(simulation: &'a Simulation) -> Self {
        *simulation.advancing() = Some(thread::current().id());
        Self(simulation)
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
        // A panic under this lock has been reported.
        self.live.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Calls the run; refuses a law that calls the run which waits for its value.
    pub(crate) fn asked<T: Send>(
        &self,
        py: Python<'_>,
        once: impl FnOnce(&mut Live) -> T + Send,
    ) -> PyResult<T> {
        if *self.advancing() == Some(thread::current().id()) {
            let message = "a custom law calls the simulation that is waiting for its value";
            return Err(error::of_work(py, &Error::BadInput(message.to_owned())));
        }
        Ok(py.detach(|| once(&mut self.live())))
    }
}

/// Columns of the rows from this one on, as in a table.
fn columns<T>(declared: &'static [Declared<T>], state: &T, row: usize) -> Vec<Column> {
    let columns = declared.iter().filter_map(|column| match (column.rows_from)(state, row) {
        Values::Numbers(numbers) => {
            let number = |number: &f64| number.is_finite().then_some(*number);
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
    /// Advances by this many seconds.
    fn advance(&self, py: Python<'_>, seconds: f64, listener: &Bound<'_, PyAny>) -> PyResult<()> {
        // Refused before a thread waits for it.
        let on_rock = self.asked(py, |live| live.is_on_rock())?;
        let advance = |observer: &dyn Observer, cancellation: &CancellationToken| {
            let mut live = self.live();
            let _advancing = Advancing::new(self);
            live.advance(seconds, observer, cancellation)
        };
        // On rock a sample may take longer than the interval between checks for an interrupt.
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

    /// Applies set points from now on, within `ramp_s`.
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

    /// Sets the kinetic friction coefficient of the hole, or of each of its sections, within
    /// `ramp_s`.
    fn set_friction(&self, py: Python<'_>, ramp_s: f64, kinetic: Vec<f64>) -> PyResult<()> {
        let set = self.asked(py, |live| live.set_friction(&kinetic, ramp_s))?;
        set.map_err(|error| error::of_work(py, &error))
    }

    /// The present kinetic friction coefficient of each hole section.
    fn friction(&self, py: Python<'_>) -> PyResult<Vec<f64>> {
        self.asked(py, |live| live.simulation().friction())
    }

    /// Time, end, sample interval, all in s, and whether it settles.
    fn clock(&self, py: Python<'_>) -> PyResult<(f64, f64, f64, bool)> {
        self.asked(py, |live| {
            let simulation = live.simulation();
            (
                simulation.time_s(),
                simulation.end_time_s(),
                simulation.sample_interval_s(),
                simulation.is_settling(),
            )
        })
    }

    /// The last sample, by the column names of the table against time; empty before the first, NaN
    /// if a column has no value.
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

    /// Drops the samples before a time, s.
    fn forget(&self, py: Python<'_>, before_s: f64) -> PyResult<()> {
        self.asked(py, |live| live.forget(before_s))
    }

    /// The present state of the whole string.
    fn state(&self, py: Python<'_>) -> PyResult<Table> {
        let columns = self.asked(py, |live| columns(FRAME, &live.simulation().frame(), 0))?;
        Table::of(&StoredTable::new(columns))
    }

    /// The results so far.
    fn answers(&self, py: Python<'_>) -> PyResult<Answers> {
        Ok(self.asked(py, |live| live.answers())?.into())
    }

    /// The whole run, as bytes.
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
