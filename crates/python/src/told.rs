//! What work says while it goes on, kept until Python looks at it.

use std::sync::{Mutex, MutexGuard, PoisonError};

use pyo3::prelude::*;
use wholestring_case::Report;
use wholestring_runner::{BatchSize, CaseEnded, Observer, Progress, Task};

/// What work has said and Python has not heard yet.
#[derive(Default)]
pub(crate) struct Told(Mutex<State>);

#[derive(Default)]
struct State {
    progress: Option<(String, Progress)>,
    /// How many cases of a batch have ended, and how many there are.
    cases: Option<(usize, usize)>,
    sentences: Vec<(bool, String)>,
}

impl Told {
    fn state(&self) -> MutexGuard<'_, State> {
        // Whoever panicked with it left whole sentences all the same.
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Tells a Python object what was said since: `progress(name, time_s, end_s)`,
    /// `said(is_warning, sentence)`, and of a batch `cases(ended, of)`.
    pub(crate) fn tell(&self, py: Python<'_>, listener: &Bound<'_, PyAny>) -> PyResult<()> {
        let State { progress, cases, sentences } = std::mem::take(&mut *self.state());
        let _ = py;
        for (is_warning, sentence) in sentences {
            listener.call_method1("said", (is_warning, sentence))?;
        }
        if let Some((name, at)) = progress {
            listener.call_method1("progress", (name, at.time_s, at.end_s))?;
        }
        if let Some((ended, of)) = cases {
            listener.call_method1("cases", (ended, of))?;
        }
        Ok(())
    }
}

impl Observer for Told {
    fn diagnostics(&self, report: &Report) {
        self.state().sentences.push((true, report.render(false)));
    }

    fn batch_started(&self, size: &BatchSize) {
        self.state().cases = Some((size.finished, size.cases));
    }

    fn case_ended(&self, of: &CaseEnded) {
        self.state().cases = Some((of.ended, of.of));
    }

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
