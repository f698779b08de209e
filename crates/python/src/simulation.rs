//! A dynamic run in hand.

use std::sync::{Mutex, MutexGuard, PoisonError};

use pyo3::{prelude::*, types::PyBytes};
use wholestring::{
    dynamics::{FRAME, HoistSetPoint, ScheduleStep},
    outcome::Values,
};
use wholestring_results::{Column, Data, Table as StoredTable};
use wholestring_runner::run::Live;

use crate::{answers::Answers, attended::attended, error, table::Table};

/// A dynamic run that Python takes forward.
#[pyclass(frozen, module = "wholestring._core")]
pub(crate) struct Simulation(Mutex<Live>);

impl From<Live> for Simulation {
    fn from(live: Live) -> Self {
        Self(Mutex::new(live))
    }
}

impl Simulation {
    fn live(&self) -> MutexGuard<'_, Live> {
        // Whoever panicked with it has said so.
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn asked<T: Send>(&self, py: Python<'_>, of: impl FnOnce(&Live) -> T + Send) -> T {
        py.detach(|| of(&self.live()))
    }
}

#[pymethods]
impl Simulation {
    /// Advances by so many seconds.
    fn advance(&self, py: Python<'_>, seconds: f64, listener: &Bound<'_, PyAny>) -> PyResult<()> {
        let work = attended(py, listener, |observer, cancellation| {
            self.live().advance(seconds, observer, cancellation)
        })?;
        match (work.raised, work.result) {
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
        let added = py.detach(|| self.live().add_to_schedule(line));
        added.map_err(|error| error::of_work(py, &error))
    }

    /// Time, end, sample interval, all in s, and whether it settles.
    fn clock(&self, py: Python<'_>) -> (f64, f64, f64, bool) {
        self.asked(py, |live| {
            let of = live.simulation();
            (of.time_s(), of.end_time_s(), of.sample_interval_s(), of.is_settling())
        })
    }

    /// The last sample, by the names of the columns of the table against time; NaN where there is
    /// none.
    fn last(&self, py: Python<'_>) -> Vec<(&'static str, f64)> {
        self.asked(py, |live| {
            let series = live.simulation().series();
            let columns = wholestring::outcome::TIME_SERIES.iter();
            let last = columns.filter_map(|column| match (column.of)(series) {
                Values::Numbers(numbers) => {
                    Some((column.quantity.name, numbers.last().copied().unwrap_or(f64::NAN)))
                }
                Values::Words(_) => None,
            });
            last.collect()
        })
    }

    /// The whole string as it is now.
    fn state(&self, py: Python<'_>) -> PyResult<Table> {
        let columns = self.asked(py, |live| {
            let frame = live.simulation().frame();
            let columns = FRAME.iter().filter_map(|column| match (column.of)(&frame) {
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
            columns.collect::<Vec<_>>()
        });
        Table::of(&StoredTable::new(columns))
    }

    /// The answers so far.
    fn answers(&self, py: Python<'_>) -> Answers {
        self.asked(py, Live::answers).into()
    }

    /// All of it, as bytes.
    fn checkpoint<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        let bytes = self.asked(py, Live::checkpoint);
        let bytes = bytes.map_err(|error| error::of_work(py, &error))?;
        Ok(PyBytes::new(py, &bytes))
    }

    /// Name of the operation.
    #[getter]
    fn operation(&self, py: Python<'_>) -> &'static str {
        self.asked(py, |live| live.operation().kind.name())
    }
}
