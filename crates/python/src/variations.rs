//! Cases of a sweep that are solved separately: in another process, or on another machine.

use std::{
    collections::BTreeMap,
    io,
    path::{Path, PathBuf},
    sync::mpsc,
    thread,
    time::Duration,
};

use pyo3::{exceptions::PyKeyboardInterrupt, prelude::*, types::PyBytes};
use wholestring_case::{Override, Template};
use wholestring_runner::{CancellationToken, sweep::RemoteCase};

use crate::{attended::attended, case::change, error};

/// Interval at which a worker checks whether its sweep is still running.
const LOOK: Duration = Duration::from_millis(50);

/// Name of a case, its changes, and its folder.
type Task = (String, Vec<(String, String)>, PathBuf);

/// A case's text and files, of which a worker solves variations.
#[pyclass(frozen, module = "wholestring._core")]
pub(crate) struct Variations(Template);

#[pymethods]
impl Variations {
    #[new]
    fn new(name: &str, text: &str, files: BTreeMap<String, Vec<u8>>) -> Self {
        Self(Template::in_memory(name, text, files))
    }

    /// Solves cases one after the other, each a name, its changes and its folder, and returns their
    /// outcomes. Cases are omitted that had not started when it was interrupted, or when the file
    /// `running` was removed.
    fn solve<'py>(
        &self,
        py: Python<'py>,
        cases: Vec<Task>,
        options: &str,
        running: Option<PathBuf>,
        listener: &Bound<'py, PyAny>,
    ) -> PyResult<Vec<Bound<'py, PyBytes>>> {
        let options = serde_json::from_str(options)
            .map_err(|error| error::bad_input(format!("no options of a sweep: {error}")))?;
        let work = attended(py, listener, |observer, cancellation| {
            let solve = || -> Result<Vec<Vec<u8>>, serde_json::Error> {
                let mut all = Vec::new();
                for (name, changes, folder) in &cases {
                    if cancellation.is_cancelled() {
                        break;
                    }
                    let changes: Vec<Override> =
                        changes.iter().map(|(key, value)| change(key, Some(value))).collect();
                    let (template, changes) = (&self.0, &changes[..]);
                    let case = RemoteCase { template, changes, name, options };
                    let ended = case.solve(folder, observer, cancellation);
                    all.push(serde_json::to_vec(&ended)?);
                }
                Ok(all)
            };
            while_running(running.as_deref(), cancellation, solve)
        })?;
        // An interrupted solver reports its progress.
        if let Some(raised) =
            work.raised.filter(|raised| !raised.is_instance_of::<PyKeyboardInterrupt>(py))
        {
            return Err(raised);
        }
        let ended = work.result.map_err(|error| error::of_refused_thread(py, &error))?;
        let ended = ended.map_err(|_| error::of_panic(py))?;
        Ok(ended.iter().map(|bytes| PyBytes::new(py, bytes)).collect())
    }
}

/// Does the work, and cancels it when the file is removed.
///
/// # Errors
/// A thread that the system refuses.
fn while_running<T>(
    file: Option<&Path>,
    cancellation: &CancellationToken,
    work: impl FnOnce() -> T,
) -> io::Result<T> {
    let Some(file) = file else { return Ok(work()) };
    thread::scope(|scope| {
        let (ended, end) = mpsc::channel::<()>();
        thread::Builder::new().spawn_scoped(scope, move || {
            while end.recv_timeout(LOOK) == Err(mpsc::RecvTimeoutError::Timeout) {
                if !file.exists() {
                    cancellation.cancel();
                }
            }
        })?;
        // Dropped when the work is done, however it ends.
        let _ended = ended;
        Ok(work())
    })
}
