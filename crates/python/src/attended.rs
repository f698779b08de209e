//! Long work with Python free beside it: other Python threads run, an interrupt ends it within a
//! tenth of a second, and its progress is told.

use std::{
    sync::mpsc::{RecvTimeoutError, channel},
    thread,
    time::Duration,
};

use pyo3::prelude::*;
use wholestring_runner::{CancellationToken, Observer};

use crate::{error, told::Told};

/// How often Python is asked for an interrupt and told of the progress.
const LOOK: Duration = Duration::from_millis(50);

/// What work came to, and what was raised meanwhile: an interrupt, or an error of the listener. The
/// work was then cancelled and has kept what it had.
pub(crate) struct Attended<T> {
    pub(crate) result: T,
    pub(crate) raised: Option<PyErr>,
}

/// Does the work on a thread of its own, and looks after Python on this one. The listener is told
/// what [`Told`] tells.
///
/// # Errors
/// Work that panicked.
pub(crate) fn attended<T: Send>(
    py: Python<'_>,
    listener: &Bound<'_, PyAny>,
    work: impl FnOnce(&dyn Observer, &CancellationToken) -> T + Send,
) -> PyResult<Attended<T>> {
    let cancellation = CancellationToken::new();
    let told = Told::default();
    let listener_free = listener.clone().unbind();
    let look = || {
        Python::attach(|py| {
            py.check_signals()?;
            told.tell(listener_free.bind(py))
        })
    };
    let (result, raised) = py.detach(|| {
        thread::scope(|scope| {
            let (ended, end) = channel();
            let worker = scope.spawn(|| {
                // Dropped when the work is done, however it ends.
                let _ended = ended;
                work(&told, &cancellation)
            });
            let mut raised = None;
            while end.recv_timeout(LOOK) == Err::<(), _>(RecvTimeoutError::Timeout) {
                if raised.is_none()
                    && let Err(error) = look()
                {
                    cancellation.cancel();
                    raised = Some(error);
                }
            }
            (worker.join(), raised)
        })
    });
    let Ok(result) = result else {
        return Err(raised.unwrap_or_else(|| error::of_panic(py)));
    };
    // What was said last.
    let raised = raised.or(told.tell(listener).err());
    Ok(Attended { result, raised })
}
