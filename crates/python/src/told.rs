//! What work says while it goes on, kept until Python looks at it.

use std::sync::{Mutex, MutexGuard, PoisonError};

use pyo3::prelude::*;
use wholestring_runner::{Observer, Progress, Task};

/// What work has said and Python has not heard yet.
#[derive(Default)]
pub(crate) struct Told(Mutex<State>);

#[derive(Default)]
struct State {
    progress: Option<(String, Progress)>,
    sentences: Vec<(bool, String)>,
}

impl Told {
    fn state(&self) -> MutexGuard<'_, State> {
        // Whoever panicked with it left whole sentences all the same.
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Tells a Python object what was said since: `progress(name, time_s, end_s)`,
    /// `said(is_warning, sentence)`.
    pub(crate) fn tell(&self, py: Python<'_>, listener: &Bound<'_, PyAny>) -> PyResult<()> {
        let (progress, sentences) = {
            let mut state = self.state();
            (state.progress.take(), std::mem::take(&mut state.sentences))
        };
        let _ = py;
        for (is_warning, sentence) in sentences {
            listener.call_method1("said", (is_warning, sentence))?;
        }
        if let Some((name, at)) = progress {
            listener.call_method1("progress", (name, at.time_s, at.end_s))?;
        }
        Ok(())
    }
}

impl Observer for Told {
    fn note(&self, text: &str) {
        self.state().sentences.push((false, text.to_owned()));
    }

    fn warning(&self, text: &str) {
        self.state().sentences.push((true, text.to_owned()));
    }

    fn reached(&self, task: &Task<'_>, progress: &Progress) {
        self.state().progress = Some((task.name.to_owned(), *progress));
    }
}
