//! Messages of work in progress, kept until Python reads them.

use std::{
    collections::HashMap,
    sync::{Mutex, MutexGuard, PoisonError},
};

use pyo3::prelude::*;
use wholestring_case::Report;
use wholestring_runner::{BatchSize, CaseEnded, Observer, Progress, Task};

/// Messages that Python has not received yet.
#[derive(Default)]
pub(crate) struct EventBuffer(Mutex<State>);

#[derive(Default)]
struct State {
    progress: Option<(String, Progress)>,
    batch: Option<Batch>,
    sentences: Vec<(bool, String)>,
}

/// Progress of a batch.
struct Batch {
    ended: usize,
    cases: usize,
    /// Finished and total work, s: simulated time, and a millisecond for each case, so that those
    /// without simulated time count too.
    done_s: f64,
    all_s: f64,
    /// The simulation of each running case: reached time and end, s.
    running: HashMap<usize, [f64; 2]>,
    /// Whether Python has received this.
    heard: bool,
}

/// Simulated time that a case counts in addition to its own, s.
const CASE_S: f64 = 1e-3;

impl EventBuffer {
    fn state(&self) -> MutexGuard<'_, State> {
        // The data are consistent even after a panic under this lock.
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Reports the new messages to a Python object: `progress(name, time_s, end_s)`, `batch(ended,
    /// of, part)`, `said(is_warning, sentence)`.
    pub(crate) fn tell(&self, listener: &Bound<'_, PyAny>) -> PyResult<()> {
        let (progress, batch, sentences) = {
            let mut state = self.state();
            let batch = state.batch.as_mut().filter(|batch| !batch.heard).map(|batch| {
                batch.heard = true;
                (batch.ended, batch.cases, (batch.done_s / batch.all_s).min(1.0))
            });
            (state.progress.take(), batch, std::mem::take(&mut state.sentences))
        };
        for (is_warning, sentence) in sentences {
            listener.call_method1("said", (is_warning, sentence))?;
        }
        if let Some(batch) = batch {
            listener.call_method1("batch", batch)?;
        }
        if let Some((name, at)) = progress {
            listener.call_method1("progress", (name, at.time_s, at.end_s))?;
        }
        Ok(())
    }

    fn say(&self, is_warning: bool, sentence: &str) {
        self.state().sentences.push((is_warning, sentence.to_owned()));
    }

    fn in_batch(&self, once: impl FnOnce(&mut Batch)) {
        if let Some(batch) = &mut self.state().batch {
            once(batch);
            batch.heard = false;
        }
    }
}

impl Observer for EventBuffer {
    fn diagnostics(&self, report: &Report) {
        self.say(true, report.render(false).trim_end());
    }

    fn note(&self, text: &str) {
        self.say(false, text);
    }

    fn warning(&self, text: &str) {
        self.say(true, text);
    }

    fn started(&self, task: &Task<'_>, _: f64, end_s: f64) {
        // The number of trials is not known in advance.
        if task.trial.is_none() {
            self.in_batch(|batch| {
                batch.running.insert(task.case, [0.0, end_s]);
            });
        }
    }

    fn reached(&self, task: &Task<'_>, progress: &Progress) {
        let mut state = self.state();
        let Some(batch) = &mut state.batch else {
            state.progress = Some((task.name.to_owned(), *progress));
            return;
        };
        if let Some([reached_s, end_s]) = batch.running.get_mut(&task.case) {
            // The operation is shorter than expected.
            batch.all_s -= (*end_s - progress.end_s).max(0.0);
            batch.done_s += (progress.time_s - *reached_s).max(0.0);
            [*reached_s, *end_s] = [progress.time_s, progress.end_s];
            batch.heard = false;
        }
    }

    fn batch_started(&self, size: &BatchSize) {
        self.state().batch = Some(Batch {
            ended: size.finished,
            cases: size.cases,
            done_s: 0.0,
            all_s: CASE_S * size.cases as f64 + size.simulated_s,
            running: HashMap::new(),
            heard: false,
        });
    }

    fn case_ended(&self, ended: &CaseEnded) {
        self.in_batch(|batch| {
            (batch.ended, batch.cases) = (ended.ended, ended.of);
            batch.done_s += CASE_S + ended.reused_s;
        });
    }
}
