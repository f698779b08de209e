//! Options of commands, and the errors of their values.

use pyo3::prelude::*;
use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_runner::{Error, job};

use crate::error;

/// The error of an option's value.
fn bad(option: &str, reason: impl std::fmt::Display) -> Error {
    Error::BadInput(format!("`{option}`: {reason}"))
}

pub(crate) fn operation(name: &str) -> Result<OperationKind, Error> {
    job::operation(name).map_err(|reason| bad("operation", reason))
}

/// The static model with a name.
pub(crate) fn statics(name: &str) -> Result<ModelKind, Error> {
    let found = ModelKind::ALL.iter().copied().find(|model| model.name() == name);
    found.filter(|model| !ModelKind::any_in_time(&[*model])).ok_or_else(|| no_statics(name))
}

pub(crate) fn no_statics(name: &str) -> Error {
    bad("model", format!("`{name}` is none of soft, stiff"))
}

/// The values of an option: a list or a range of quantities of a dimension, SI.
#[pyfunction]
pub(crate) fn values(
    py: Python<'_>,
    option: &str,
    text: &str,
    dimension: &str,
) -> PyResult<Vec<f64>> {
    let found = crate::dimension::dimension(dimension)?;
    let values = wholestring_case::read_values(option, text, found);
    values.map_err(|report| error::of_report(py, &report))
}
