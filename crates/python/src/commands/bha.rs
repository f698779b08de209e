//! An assembly at rest.

use pyo3::prelude::*;
use wholestring_runner::bha;

use super::{
    carry_out::{Ended, carry_out_or_leave},
    common::Common,
    option::operation,
};
use crate::case::Case;

/// What is asked of an assembly at rest.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct BhaOptions {
    operation: Option<String>,
    toolfaces_rad: Option<Vec<f64>>,
    weights_N: Option<Vec<f64>>,
    inclinations_rad: Option<Vec<f64>>,
    build_rate_rad_per_m: f64,
    whole: bool,
}

#[pyfunction]
pub(crate) fn bha_of(
    py: Python<'_>,
    case: &Case,
    options: BhaOptions,
    common: Common,
    listener: &Bound<'_, PyAny>,
) -> PyResult<Ended> {
    let case = case.case.clone();
    carry_out_or_leave(py, listener, move |observer, cancellation| {
        let request = bha::Request {
            operation: options.operation.as_deref().map(operation).transpose()?,
            whole: options.whole,
            sweeps: bha::Sweeps {
                toolfaces_rad: options.toolfaces_rad,
                weights_N: options.weights_N,
                inclinations_rad: options.inclinations_rad,
                build_rate_rad_per_m: options.build_rate_rad_per_m,
            },
            units: common.units()?,
            output: common.output(),
            csv: common.csv,
            jobs: common.jobs,
            ..bha::Request::new(&case)
        };
        Ok((bha::run(&request, observer, cancellation)?.folder, None))
    })
}
