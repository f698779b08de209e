//! Work of commands while Python stays free.

use std::path::PathBuf;

use pyo3::prelude::*;
use wholestring_runner::{BatchOutcome, CancellationToken, Error, Observer};

use crate::{
    attended::{Attended, attended},
    error,
};

/// The results folder, if there is one, and the exception raised before the end.
pub(super) type Ended = (Option<PathBuf>, Option<Py<PyAny>>);

/// The results folder, and the error that ended the work early.
pub(super) type Found = (PathBuf, Option<Error>);

/// Does the work while Python stays free.
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

/// The folder of a batch, and the reason why it is incomplete.
pub(super) fn ended(batch: BatchOutcome) -> Found {
    let folder = batch.folder.clone();
    (folder, batch.finished().err())
}
