//! Options of commands, and the errors of their values.

use std::time::Duration;

use pyo3::prelude::*;
use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_runner::{Error, Keep, job};

use crate::error;

/// The error of an option's value.
pub(crate) fn bad(option: &str, reason: impl std::fmt::Display) -> Error {
    Error::BadInput(format!("`{option}`: {reason}"))
}

/// Wall-clock time between checkpoints.
pub(crate) fn checkpoint_every(
    option: &str,
    seconds: Option<f64>,
) -> Result<Option<Duration>, Error> {
    match seconds {
        Some(seconds) if !(0.01..=86_400.0).contains(&seconds) => {
            Err(bad(option, format!("{seconds} s: expected 0.01 s to 86400 s")))
        }
        seconds => Ok(seconds.map(Duration::from_secs_f64)),
    }
}

/// Results to keep of each case of a batch.
pub(crate) fn keep(word: Option<&str>) -> Result<Option<Keep>, Error> {
    let named = |word: &str| {
        let refused =
            || bad("keep", format!("`{word}`: expected \"summary\", \"tables\" or \"all\""));
        Keep::named(word).ok_or_else(refused)
    };
    word.map(named).transpose()
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
