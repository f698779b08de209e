//! A test of the bit.

use pyo3::prelude::*;
use wholestring_runner::bit_test;

use super::{
    carry_out::{Ended, carry_out, ended},
    common::Common,
};
use crate::case::Case;

#[pyfunction]
pub(crate) fn bit_test_of(
    py: Python<'_>,
    case: &Case,
    common: Common,
    listener: &Bound<'_, PyAny>,
) -> PyResult<Ended> {
    carry_out(py, listener, |observer, cancellation| {
        let (units, batch) = (common.units()?, common.batch()?);
        let request = bit_test::Request { case: &case.case, units, batch };
        Ok(ended(bit_test::run(&request, observer, cancellation)?.batch))
    })
}
