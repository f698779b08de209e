//! Work of commands beside Python.

use std::path::PathBuf;

use pyo3::prelude::*;
use wholestring_runner::{BatchOutcome, CancellationToken, Error, Observer};

use crate::{
    attended::{Attended, attended},
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
    let value = |raised: PyErr| raised.into_value(py).into_any();
    match (result, raised) {
        (Ok((folder, stopped)), raised) => {
            let stopped = || stopped.map(|stop| error::of_work(py, &stop));
            Ok((Some(folder), raised.or_else(stopped).map(value)))
        }
        (Err(_), Some(raised)) => Ok((None, Some(value(raised)))),
        (Err(stop), None) => Err(error::of_work(py, &stop)),
    }
}

/// The folder of a batch, and why it is not whole.
pub(super) fn ended(batch: BatchOutcome) -> Found {
    let folder = batch.folder.clone();
    (folder, batch.finished().err())
}
