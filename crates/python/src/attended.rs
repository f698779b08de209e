//! Long work that leaves Python free: other Python threads run, an interrupt cancels it within some
//! hundredths of a second, and Python receives its progress.

use std::{
    sync::{
        Mutex, PoisonError,
        mpsc::{Receiver, RecvTimeoutError, channel},
    },
    thread,
    time::{Duration, Instant},
};

use pyo3::prelude::*;
use wholestring_runner::{CancellationToken, Observer, Progress, Task};

use crate::{error, event_buffer::EventBuffer};

/// Interval between checks for an interrupt and reports of the progress.
const LOOK: Duration = Duration::from_millis(5);

/// Result of work, and the exception raised meanwhile: an interrupt, or an error of the listener.
/// The work was then cancelled and has kept its results so far.
pub(crate) struct Attended<T> {
    pub(crate) result: T,
    pub(crate) raised: Option<PyErr>,
}

/// Does the work on a thread of its own, and serves Python on this one. The listener receives the
/// messages of [`EventBuffer`].
///
/// # Errors
/// Work that panicked, a thread that the system refuses.
pub(crate) fn attended<T: Send>(
    py: Python<'_>,
    listener: &Bound<'_, PyAny>,
    work: impl FnOnce(&dyn Observer, &CancellationToken) -> T + Send,
) -> PyResult<Attended<T>> {
    let cancellation = CancellationToken::new();
    let events = EventBuffer::default();
    let free = listener.clone().unbind();
    let worked = py.detach(|| {
        thread::scope(|scope| {
            let (ended, end) = channel::<()>();
            let (events, cancellation) = (&events, &cancellation);
            let worker = thread::Builder::new().spawn_scoped(scope, move || {
                // Dropped when the work is done, however it ends.
                let _ended = ended;
                work(events, cancellation)
            })?;
            let raised = look_after(&end, cancellation, events, &free);
            Ok((worker.join(), raised))
        })
    });
    let (result, raised) = worked.map_err(|error| error::of_refused_thread(py, &error))?;
    let Ok(result) = result else {
        return Err(raised.unwrap_or_else(|| error::of_panic(py)));
    };
    // The last messages.
    let raised = raised.or(events.tell(listener).err());
    Ok(Attended { result, raised })
}

/// Serves Python until the work has ended; returns the exception raised, if any.
fn look_after(
    end: &Receiver<()>,
    cancellation: &CancellationToken,
    events: &EventBuffer,
    listener: &Py<PyAny>,
) -> Option<PyErr> {
    let mut raised = None;
    while end.recv_timeout(LOOK) == Err(RecvTimeoutError::Timeout) {
        if raised.is_none() {
            let look = Python::attach(|py| {
                py.check_signals()?;
                events.tell(listener.bind(py))
            });
            raised = look.err();
            if raised.is_some() {
                cancellation.cancel();
            }
        }
    }
    raised
}

/// Does work that often reports its progress, and serves Python in between: on this thread, for
/// work that may be too short for one of its own.
///
/// # Errors
/// None: an exception raised meanwhile is in the result.
pub(crate) fn attended_here<T: Send>(
    py: Python<'_>,
    listener: &Bound<'_, PyAny>,
    work: impl FnOnce(&dyn Observer, &CancellationToken) -> T + Send,
) -> Attended<T> {
    let cancellation = CancellationToken::new();
    let looking = Looking {
        events: EventBuffer::default(),
        listener: listener.clone().unbind(),
        cancellation: cancellation.clone(),
        at: Mutex::new((Instant::now(), None)),
    };
    let result = py.detach(|| work(&looking, &cancellation));
    let (_, raised) = looking.at.into_inner().unwrap_or_else(PoisonError::into_inner);
    // The last messages.
    let raised = raised.or(looking.events.tell(listener).err());
    Attended { result, raised }
}

/// Receives the messages of work, and serves Python at intervals.
struct Looking {
    events: EventBuffer,
    listener: Py<PyAny>,
    cancellation: CancellationToken,
    /// Time of the last check, and the exception raised then.
    at: Mutex<(Instant, Option<PyErr>)>,
}

impl Observer for Looking {
    fn note(&self, text: &str) {
        self.events.note(text);
    }

    fn warning(&self, text: &str) {
        self.events.warning(text);
    }

    fn reached(&self, task: &Task<'_>, progress: &Progress) {
        self.events.reached(task, progress);
        let mut at = self.at.lock().unwrap_or_else(PoisonError::into_inner);
        if at.0.elapsed() < LOOK || at.1.is_some() {
            return;
        }
        let looked = Python::attach(|py| {
            py.check_signals()?;
            self.events.tell(self.listener.bind(py))
        });
        if let Err(error) = looked {
            self.cancellation.cancel();
            at.1 = Some(error);
        }
        at.0 = Instant::now();
    }
}
