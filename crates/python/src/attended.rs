//! Long work with Python free beside it: other Python threads run, an interrupt cancels it within
//! some hundredths of a second, and Python hears of its progress.

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

/// How often Python is asked for an interrupt and told of the progress.
const LOOK: Duration = Duration::from_millis(5);

/// What work came to, and what was raised meanwhile: an interrupt, or an error of the listener. The
/// work was then cancelled and has kept what it had.
pub(crate) struct Attended<T> {
    pub(crate) result: T,
    pub(crate) raised: Option<PyErr>,
}

/// Does the work on a thread of its own, and looks after Python on this one. The listener is told
/// what [`EventBuffer`] tells.
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
    // What was said last.
    let raised = raised.or(events.tell(listener).err());
    Ok(Attended { result, raised })
}

/// Looks after Python until the work has ended: what was raised, if anything was.
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

/// Does work that tells its progress often, and looks after Python between: on this thread, for
/// work that may be too short for one of its own.
///
/// # Errors
/// None: what was raised meanwhile is in the answer.
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
    // What was said last.
    let raised = raised.or(looking.events.tell(listener).err());
    Attended { result, raised }
}

/// Hears what work says, and looks after Python now and then.
struct Looking {
    events: EventBuffer,
    listener: Py<PyAny>,
    cancellation: CancellationToken,
    /// When it looked last, and what was raised then.
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
