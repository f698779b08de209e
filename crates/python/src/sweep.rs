//! Sweeps controlled from Python.

use std::{
    path::{Path, PathBuf},
    sync::{Mutex, MutexGuard, PoisonError},
};

use pyo3::{prelude::*, types::PyBytes};
use wholestring_case::Override;
use wholestring_runner::{
    BatchOutcome, CancellationToken, Error,
    sweep::{self, Ended, PreparedSweep},
};

use crate::{
    attended::attended,
    case::Case,
    error,
    job::{Files, job_of},
    table::Table,
};

/// A sweep that is checked, holds its folder, and is ready to solve its cases.
#[pyclass(frozen, module = "wholestring._core")]
pub(crate) struct Sweep(Mutex<Option<PreparedSweep>>);

/// Failed cases, each with its reason, and whether the sweep was interrupted.
type Outcome = (Vec<(String, String)>, bool);

fn outcome(outcome: BatchOutcome) -> Outcome {
    let interrupted = outcome.is_interrupted();
    let failed = outcome.failed.into_iter().map(|failed| (failed.name, failed.reason));
    (failed.collect(), interrupted)
}

impl Sweep {
    fn with<T: Send>(
        &self,
        py: Python<'_>,
        work: impl FnOnce(&mut PreparedSweep) -> T + Send,
    ) -> PyResult<T> {
        let done = py.detach(|| self.held().as_mut().map(work));
        done.ok_or_else(ended)
    }

    fn held(&self) -> MutexGuard<'_, Option<PreparedSweep>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The error with the name that the interval between checkpoints has in `sweep`.
fn in_words_of_sweep(error: Error) -> Error {
    match error {
        Error::BadInput(reason) => {
            Error::BadInput(reason.replace("`checkpoint`", "`checkpoint_every`"))
        }
        error => error,
    }
}

fn ended() -> PyErr {
    error::bad_input("this sweep has ended")
}

#[pymethods]
impl Sweep {
    /// Reads and checks every case of a job, and claims the folder.
    #[staticmethod]
    fn begin(
        py: Python<'_>,
        job: &str,
        case: &Case,
        folder: Option<PathBuf>,
        listener: &Bound<'_, PyAny>,
    ) -> PyResult<Self> {
        let job = job_of(job, folder)?;
        let files = Files::of_cases([("", case)]);
        let work = attended(py, listener, |observer, cancellation| {
            job.begin_sweep(&files, observer, cancellation)
        })?;
        match (work.raised, work.result) {
            (Some(raised), _) => Err(raised),
            (None, Ok(hand)) => Ok(Self(Mutex::new(Some(hand)))),
            (None, Err(error)) => Err(error::of_work(py, &in_words_of_sweep(error))),
        }
    }

    /// Solves the cases here, on all cores: the outcome, and the exception raised before the end,
    /// if any.
    fn run(
        &self,
        py: Python<'_>,
        listener: &Bound<'_, PyAny>,
    ) -> PyResult<(Outcome, Option<Py<PyAny>>)> {
        let hand = self.held().take().ok_or_else(ended)?;
        let work =
            attended(py, listener, |observer, cancellation| hand.solve(observer, cancellation))?;
        let done = work.result.map_err(|error| error::of_work(py, &error))?;
        let raised = work.raised.map(|raised| raised.into_value(py).into_any());
        Ok((outcome(done), raised))
    }

    /// The results folder.
    fn folder(&self, py: Python<'_>) -> PyResult<PathBuf> {
        self.with(py, |hand| hand.folder().to_owned())
    }

    /// Names of the cases, in their order.
    fn names(&self, py: Python<'_>) -> PyResult<Vec<String>> {
        self.with(py, |hand| (0..hand.count()).map(|case| hand.name(case).to_owned()).collect())
    }

    /// The cases to be solved, the longest first.
    fn left(&self, py: Python<'_>) -> PyResult<Vec<usize>> {
        self.with(py, PreparedSweep::left)
    }

    /// The changes of a case.
    fn changes(&self, py: Python<'_>, case: usize) -> PyResult<Vec<(String, String)>> {
        let pair = |change: &Override| (change.key.clone(), change.value.clone());
        self.with(py, |hand| hand.changes(case).iter().map(pair).collect())
    }

    /// Options for workers that solve its cases, as [`Variations`](crate::variations::Variations)
    /// reads them.
    fn remote_options(&self, py: Python<'_>) -> PyResult<String> {
        let options = self.with(py, |hand| hand.remote_options())?;
        serde_json::to_string(&options).map_err(|_| error::of_panic(py))
    }

    /// Prepares a case's folder for its solver.
    fn make_ready(&self, py: Python<'_>, case: usize) -> PyResult<PathBuf> {
        let ready = self.with(py, |hand| hand.make_ready(case))?;
        ready.map_err(|error| error::of_work(py, &error))
    }

    /// The files with which another machine continues an unfinished case.
    fn begun<'py>(
        &self,
        py: Python<'py>,
        case: usize,
    ) -> PyResult<Vec<(String, Bound<'py, PyBytes>)>> {
        let begun = self.with(py, |hand| hand.begun(case))?;
        Ok(begun.into_iter().map(|(name, bytes)| (name, PyBytes::new(py, &bytes))).collect())
    }

    /// Puts the files of a case that was solved elsewhere into its folder.
    fn put(&self, py: Python<'_>, case: usize, files: Vec<(String, Vec<u8>)>) -> PyResult<()> {
        let put = self.with(py, |hand| hand.put(case, &files))?;
        put.map_err(|error| error::of_work(py, &error))
    }

    /// Records the outcome of a case, and returns whether it finished: one that was stopped may be
    /// handed out again.
    fn take(&self, py: Python<'_>, case: usize, ended: &[u8]) -> PyResult<bool> {
        let ended: Ended = serde_json::from_slice(ended)
            .map_err(|error| error::bad_input(format!("no answer of a case: {error}")))?;
        let is_interrupted = ended.is_interrupted();
        self.with(py, |hand| hand.take(case, ended))?;
        Ok(!is_interrupted)
    }

    /// Records that a case failed for this reason.
    fn fail(&self, py: Python<'_>, case: usize, reason: String) -> PyResult<()> {
        self.with(py, |hand| hand.take(case, Ended::failed(reason)))
    }

    /// Writes table and page, releases the folder, and returns the outcome.
    fn end(&self, py: Python<'_>, interrupted: bool) -> PyResult<Outcome> {
        let token = CancellationToken::new();
        if interrupted {
            token.cancel();
        }
        let done = self.with(py, |hand| hand.end(&token))?;
        self.close();
        Ok(outcome(done.map_err(|error| error::of_results(py, &error))?))
    }

    /// Releases the folder.
    fn close(&self) {
        *self.held() = None;
    }
}

/// The table of a sweep in a folder, and the number of its leading columns that are varied.
pub(crate) fn table(py: Python<'_>, folder: &Path) -> PyResult<(usize, Table)> {
    let read = py.detach(|| sweep::read(folder));
    let (varied, table) = read.map_err(|error| error::of_results(py, &error))?;
    Ok((varied, Table::of(&table)?))
}
