//! A static BHA analysis.

use pyo3::prelude::*;
use wholestring_runner::{Error, bha};

use super::{
    carry_out::{Ended, carry_out},
    common::Common,
    option::operation,
};
use crate::case::Case;

/// Options of a static BHA analysis.
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
    carry_out(py, listener, |observer, cancellation| {
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
            ..bha::Request::new(&case.case)
        };
        let found = bha::run(&request, observer, cancellation)?;
        Ok((found.folder, found.interrupted.then_some(Error::Interrupted)))
    })
}
