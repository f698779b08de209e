//! A reach.

use pyo3::prelude::*;
use wholestring_runner::{Error, reach};

use super::{
    carry_out::{Ended, carry_out},
    common::Common,
    option::operation,
};
use crate::case::Case;

/// Options of a reach.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct ReachOptions {
    from_m: Option<f64>,
    to_m: Option<f64>,
    frictions: Vec<f64>,
    operations: Vec<String>,
    no_helix_friction: bool,
    stop_at_helix: bool,
}

#[pyfunction]
pub(crate) fn reach_of(
    py: Python<'_>,
    case: &Case,
    options: ReachOptions,
    common: Common,
    listener: &Bound<'_, PyAny>,
) -> PyResult<Ended> {
    carry_out(py, listener, |observer, cancellation| {
        let operations = options.operations.iter().map(|name| operation(name));
        let request = reach::Request {
            from_m: options.from_m,
            to_m: options.to_m,
            frictions: options.frictions,
            operations: operations.collect::<Result<_, _>>()?,
            helix_side_force: !options.no_helix_friction,
            stop_at_helix: options.stop_at_helix,
            units: common.units()?,
            output: common.output(),
            png: common.png,
            jobs: common.jobs,
            ..reach::Request::new(&case.case, &case.template, &case.changes)
        };
        let found = reach::run(&request, observer, cancellation)?;
        let interrupted = found.interrupted.then_some(Error::Interrupted);
        let stopped = found.samples.and_then(|batch| batch.finished().err()).or(interrupted);
        Ok((found.folder, stopped))
    })
}
