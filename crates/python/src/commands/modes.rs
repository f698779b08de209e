//! Natural frequencies and critical speeds.

use pyo3::prelude::*;
use wholestring_runner::modes;

use super::{
    carry_out::{Ended, carry_out_or_leave},
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
    let case = case.case.clone();
    carry_out_or_leave(py, listener, move |observer, cancellation| {
        let request = modes::Request {
            case: &case,
            operation: operation.as_deref(),
            units: common.units()?,
            output: common.output(),
            png: common.png,
        };
        Ok((modes::run(&request, observer, cancellation)?.folder, None))
    })
}
