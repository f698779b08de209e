//! What work says while it goes on, kept until Python looks at it.

use std::{
    collections::HashMap,
    sync::{Mutex, MutexGuard, PoisonError},
};

use pyo3::prelude::*;
use wholestring_case::Report;
use wholestring_runner::{BatchSize, CaseEnded, Observer, Progress, Task};

/// What work has said and Python has not heard yet.
#[derive(Default)]
pub(crate) struct EventBuffer(Mutex<State>);

#[derive(Default)]
struct State {
    progress: Option<(String, Progress)>,
    batch: Option<Batch>,
    sentences: Vec<(bool, String)>,
}

/// How far a batch has come.
struct Batch {
    ended: usize,
    cases: usize,
    /// What is done, and what there is to do, s: simulated time, and a millisecond for each case,
    /// so that those without any count too.
    done_s: f64,
    all_s: f64,
    /// The simulation of each case that is solved now: reached, and where it ends, s.
    running: HashMap<usize, [f64; 2]>,
    /// Whether Python has heard of this.
    heard: bool,
}

/// What a case counts beside its simulated time, s.
const CASE_S: f64 = 1e-3;

impl EventBuffer {
    fn state(&self) -> MutexGuard<'_, State> {
        // Whoever panicked with it left whole sentences all the same.
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Tells a Python object what was said since: `progress(name, time_s, end_s)`,
    /// `batch(ended, of, part)`, `said(is_warning, sentence)`.
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

    fn in_batch(&self, of: impl FnOnce(&mut Batch)) {
        if let Some(batch) = &mut self.state().batch {
            of(batch);
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
        // Nobody knows how many trials there will be.
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
            // It is shorter than it was thought to be.
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

    fn case_ended(&self, of: &CaseEnded) {
        self.in_batch(|batch| {
            (batch.ended, batch.cases) = (of.ended, of.of);
            batch.done_s += CASE_S + of.reused_s;
        });
    }
}
