//! A broomstick.

use std::num::NonZeroUsize;

use pyo3::prelude::*;
use wholestring_runner::plan::{self, Statics};

use crate::{
    attended::{Attended, attended},
    case::Case,
    error,
    option::{no_statics, operation},
    table::Table,
};

/// Options of a broomstick.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct BroomstickOptions {
    models: Vec<String>,
    frictions: Vec<f64>,
    bit_depths_m: Vec<f64>,
    operations: Vec<String>,
    jobs: Option<NonZeroUsize>,
}

/// The table, the number of its missing points, and the exception raised meanwhile.
#[pyfunction]
pub(crate) fn broomstick_of(
    py: Python<'_>,
    case: &Case,
    options: BroomstickOptions,
    listener: &Bound<'_, PyAny>,
) -> PyResult<(Table, usize, Option<Py<PyAny>>)> {
    let Attended { result, raised } = attended(py, listener, |_, cancellation| {
        let model = |name: &String| {
            let found = Statics::ALL.into_iter().find(|model| model.name() == name);
            found.ok_or_else(|| no_statics(name))
        };
        let operations = options.operations.iter().map(|name| operation(name));
        let request = plan::BroomstickRequest {
            case: &case.case,
            models: options.models.iter().map(model).collect::<Result<_, _>>()?,
            frictions: options.frictions,
            bit_depths_m: options.bit_depths_m,
            operations: operations.collect::<Result<_, _>>()?,
            jobs: options.jobs,
        };
        plan::broomstick(&request, cancellation)
    })?;
    match (result, raised) {
        (Ok(found), raised) => {
            let raised = raised.map(|raised| raised.into_value(py).into_any());
            Ok((Table::of(&found.table)?, found.missing, raised))
        }
        (Err(_), Some(raised)) => Err(raised),
        (Err(error), None) => Err(error::of_work(py, &error)),
    }
}
