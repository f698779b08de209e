//! Natural frequencies and critical speeds.

use pyo3::prelude::*;
use wholestring_runner::{Error, modes};

use super::{
    carry_out::{Ended, carry_out},
    common::Common,
};
use crate::case::Case;

#[pyfunction]
pub(crate) fn modes_of(
    py: Python<'_>,
    case: &Case,
    operation: Option<String>,
    common: Common,
    listener: &Bound<'_, PyAny>,
) -> PyResult<Ended> {
    carry_out(py, listener, |observer, cancellation| {
        let request = modes::Request {
            case: &case.case,
            operation: operation.as_deref(),
            units: common.units()?,
            output: common.output(),
            png: common.png,
            jobs: common.jobs,
        };
        let found = modes::run(&request, observer, cancellation)?;
        Ok((found.folder, found.interrupted.then_some(Error::Interrupted)))
    })
}
