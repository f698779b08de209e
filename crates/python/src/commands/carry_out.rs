//! Work of commands beside Python.

use std::path::PathBuf;

use pyo3::prelude::*;
use wholestring_runner::{BatchOutcome, CancellationToken, Error, Observer};

use crate::{
    attended::{Attended, attended, attended_or_left},
    error,
};

/// Where the results are, if there are any, and what was raised before the end.
pub(super) type Ended = (Option<PathBuf>, Option<Py<PyAny>>);

/// Where the results are, and what ended the work early.
pub(super) type Found = (PathBuf, Option<Error>);

/// Does the work beside Python.
pub(super) fn carry_out(
    py: Python<'_>,
    listener: &Bound<'_, PyAny>,
    work: impl FnOnce(&dyn Observer, &CancellationToken) -> Result<Found, Error> + Send,
) -> PyResult<Ended> {
    let Attended { result, raised } = attended(py, listener, work)?;
    came(py, Some(result), raised)
}

/// The same of work that leaves nothing when it is interrupted.
pub(super) fn carry_out_or_leave(
    py: Python<'_>,
    listener: &Bound<'_, PyAny>,
    work: impl FnOnce(&dyn Observer, &CancellationToken) -> Result<Found, Error> + Send + 'static,
) -> PyResult<Ended> {
    let Attended { result, raised } = attended_or_left(py, listener, work)?;
    came(py, result, raised)
}

/// What Python is given of what came of work.
fn came(
    py: Python<'_>,
    result: Option<Result<Found, Error>>,
    raised: Option<PyErr>,
) -> PyResult<Ended> {
    let value = |raised: PyErr| raised.into_value(py).into_any();
    match (result, raised) {
        (Some(Ok((folder, stopped))), raised) => {
            let stopped = || stopped.map(|stop| error::of_work(py, &stop));
            Ok((Some(folder), raised.or_else(stopped).map(value)))
        }
        (_, Some(raised)) => Ok((None, Some(value(raised)))),
        (Some(Err(stop)), None) => Err(error::of_work(py, &stop)),
        (None, None) => Err(error::of_panic(py)),
    }
}

/// The folder of a batch, and why it is not whole.
pub(super) fn ended(batch: BatchOutcome) -> Found {
    let folder = batch.folder.clone();
    (folder, batch.finished().err())
}
