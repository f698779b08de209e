//! A broomstick.

use std::num::NonZeroUsize;

use pyo3::prelude::*;
use wholestring_runner::plan::{self, Statics};

use super::option::{no_statics, operation};
use crate::{attended::attended_or_left, case::Case, error, table::Table};

/// What is asked of a broomstick.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct BroomstickOptions {
    models: Vec<String>,
    frictions: Vec<f64>,
    bit_depths_m: Vec<f64>,
    operations: Vec<String>,
    jobs: Option<NonZeroUsize>,
}

#[pyfunction]
pub(crate) fn broomstick_of(
    py: Python<'_>,
    case: &Case,
    options: BroomstickOptions,
    listener: &Bound<'_, PyAny>,
) -> PyResult<Table> {
    let case = case.case.clone();
    let work = attended_or_left(py, listener, move |_, cancellation| {
        let model = |name: &String| {
            let found = Statics::ALL.into_iter().find(|of| of.name() == name);
            found.ok_or_else(|| no_statics(name))
        };
        let operations = options.operations.iter().map(|name| operation(name));
        let request = plan::BroomstickRequest {
            case: &case,
            models: options.models.iter().map(model).collect::<Result<_, _>>()?,
            frictions: options.frictions,
            bit_depths_m: options.bit_depths_m,
            operations: operations.collect::<Result<_, _>>()?,
            jobs: options.jobs,
        };
        plan::broomstick(&request, cancellation)
    })?;
    match (work.raised, work.result) {
        (Some(raised), _) => Err(raised),
        (None, Some(Ok(table))) => Table::of(&table),
        (None, Some(Err(error))) => Err(error::of_work(py, &error)),
        (None, None) => Err(error::of_panic(py)),
    }
}
