//! Progress of a job, as reported to its observer.

use std::{
    collections::BTreeMap,
    path::{Path, PathBuf},
    sync::OnceLock,
    time::Instant,
};

use serde::Serialize;
use tokio::sync::watch;
use utoipa::ToSchema;
use wholestring_case::Report;
use wholestring_runner::{BatchSize, CaseEnded, Observer, Progress as Reached, Task};

use crate::results::{Found, checks};

/// Maximum number of notes and of warnings kept of a job.
const NOTES: usize = 100;

/// Maximum number of checks listed of a job; its results have all.
const FINDINGS: usize = 20;

/// Progress of a job.
#[derive(Debug, Clone, Default, Serialize, ToSchema)]
pub(crate) struct Progress {
    /// Operations, or cases of a sweep, in progress.
    pub(crate) bars: Vec<Bar>,
    /// Number of cases, points or samples, for batches.
    pub(crate) batch: Option<Batch>,
    /// Notes.
    pub(crate) notes: Vec<String>,
    /// Problems that did not end the work, and likely mistakes of the input.
    pub(crate) warnings: Vec<String>,
    /// Checks of the finished operations, the most severe first.
    pub(crate) checks: Vec<Found>,
}

/// An operation in progress.
#[derive(Debug, Clone, Serialize, ToSchema)]
pub(crate) struct Bar {
    /// Index and name of its case.
    #[serde(skip)]
    key: (usize, String),
    /// Title: `trip out`, `slide, lift 2 of at most 9`.
    title: String,
    /// The preparation before its time begins; none afterwards.
    preparing: Option<String>,
    /// Simulated time reached, s.
    reached_s: f64,
    /// Simulated time of the end, s; the latest possible one while it settles.
    end_s: f64,
    /// Whether it waits for a steady state.
    settling: bool,
    /// Remaining wall-clock time at the current pace, s.
    left_s: Option<f64>,
    #[serde(skip)]
    began: Instant,
    #[serde(skip)]
    from_s: f64,
}

/// Progress of many cases, points or samples.
#[derive(Debug, Clone, Serialize, ToSchema)]
pub(crate) struct Batch {
    /// Total number.
    of: usize,
    /// Number of finished ones.
    ended: usize,
    /// Fraction of the work that is done, from 0 to 1.
    part: f64,
    /// Remaining wall-clock time at the current pace, s.
    left_s: Option<f64>,
    #[serde(skip)]
    began: Instant,
    /// Work in simulated seconds and thousandths of a case: done, at the start, and in total.
    #[serde(skip)]
    work: [f64; 3],
    #[serde(skip)]
    cases: BTreeMap<usize, [f64; 2]>,
}

/// Simulated time that a case counts in addition to its own, s, so that soft strings move the bar
/// too.
const CASE_S: f64 = 1e-3;

impl Batch {
    fn update(&mut self) {
        let [done, before, all] = self.work;
        self.part = if all > 0.0 { (done / all).clamp(0.0, 1.0) } else { 1.0 };
        self.left_s = left_s(self.began, done - before, all - done);
    }
}

/// Wall-clock time for the remaining work, at the pace since `since`.
fn left_s(since: Instant, done: f64, left: f64) -> Option<f64> {
    let is_known = done > 0.0 && left >= 0.0;
    is_known.then(|| since.elapsed().as_secs_f64() * left / done).filter(|left| left.is_finite())
}

/// Publishes the progress of a job to its followers, who receive the latest state rather than each.
pub(super) struct Watcher<'a> {
    pub(super) progress: &'a watch::Sender<Progress>,
    /// Called with the results folder once it is locked.
    pub(super) at: &'a (dyn Fn(&Path) + Sync),
    pub(super) folder: OnceLock<PathBuf>,
}

impl Watcher<'_> {
    /// Reads the checks so far, which are written as each operation ends.
    fn look(&self) {
        if let Some(folder) = self.folder.get() {
            let mut found = checks(folder);
            found.truncate(FINDINGS);
            self.change(|now| now.checks = found);
        }
    }

    /// Clears the operations in progress.
    pub(super) fn end(&self) {
        self.change(|now| now.bars.clear());
        self.look();
    }

    fn change(&self, change: impl FnOnce(&mut Progress)) {
        self.progress.send_modify(change);
    }
}

fn title(task: &Task<'_>) -> String {
    let name = task.name.replace('_', " ");
    match task.trial {
        None => name,
        Some(trial) => format!("{name}, lift {} of at most {}", trial.number, trial.most),
    }
}

fn keep(list: &mut Vec<String>, text: String) {
    if list.len() < NOTES && !list.contains(&text) {
        list.push(text);
    }
}

impl Progress {
    fn bar(&mut self, task: &Task<'_>) -> &mut Bar {
        let key = (task.case, task.name.to_owned());
        let place = self.bars.iter().position(|bar| bar.key == key);
        let place = place.unwrap_or_else(|| {
            self.bars.push(Bar {
                key,
                title: String::new(),
                preparing: None,
                reached_s: 0.0,
                end_s: 0.0,
                settling: false,
                left_s: None,
                began: Instant::now(),
                from_s: 0.0,
            });
            self.bars.len() - 1
        });
        let bar = &mut self.bars[place];
        bar.title = title(task);
        bar
    }

    fn remove(&mut self, task: &Task<'_>) {
        self.bars.retain(|bar| bar.key.0 != task.case || bar.key.1 != task.name);
    }
}

impl Observer for Watcher<'_> {
    fn diagnostics(&self, report: &Report) {
        self.change(|now| {
            let texts = report.diagnostics.iter().map(|one| one.message.clone());
            texts.for_each(|text| keep(&mut now.warnings, text));
        });
    }

    fn note(&self, text: &str) {
        self.change(|now| keep(&mut now.notes, text.to_owned()));
    }

    fn warning(&self, text: &str) {
        self.change(|now| keep(&mut now.warnings, text.to_owned()));
    }

    fn folder(&self, path: &Path) {
        if self.folder.set(path.to_owned()).is_ok() {
            (self.at)(path);
            self.change(|_| ());
        }
    }

    fn preparing(&self, task: &Task<'_>, what: &str) {
        self.look();
        self.change(|now| now.bar(task).preparing = Some(what.to_owned()));
    }

    fn prepared(&self, task: &Task<'_>) {
        self.change(|now| now.remove(task));
    }

    fn started(&self, task: &Task<'_>, from_s: f64, end_s: f64) {
        self.change(|now| {
            let bar = now.bar(task);
            (bar.preparing, bar.began, bar.from_s) = (None, Instant::now(), from_s);
            (bar.reached_s, bar.end_s, bar.left_s) = (from_s, end_s, None);
            if task.trial.is_none()
                && let Some(batch) = &mut now.batch
            {
                batch.cases.insert(task.case, [0.0, end_s]);
            }
        });
    }

    fn reached(&self, task: &Task<'_>, at: &Reached) {
        self.change(|now| {
            let bar = now.bar(task);
            (bar.reached_s, bar.end_s, bar.settling) = (at.time_s, at.end_s, at.settling);
            bar.left_s = left_s(bar.began, at.time_s - bar.from_s, at.end_s - at.time_s);
            if task.trial.is_none()
                && let Some(batch) = &mut now.batch
                && let Some([reached_s, end_s]) = batch.cases.get_mut(&task.case)
            {
                // The operation is shorter than expected.
                batch.work[2] -= (*end_s - at.end_s).max(0.0);
                batch.work[0] += (at.time_s - *reached_s).max(0.0);
                (*reached_s, *end_s) = (at.time_s, at.end_s);
                batch.update();
            }
        });
    }

    fn ended(&self, task: &Task<'_>) {
        self.change(|now| now.remove(task));
    }

    fn batch_started(&self, size: &BatchSize) {
        self.change(|now| {
            let all = size.cases as f64 * CASE_S + size.simulated_s;
            now.batch = Some(Batch {
                of: size.cases,
                ended: 0,
                part: 0.0,
                left_s: None,
                began: Instant::now(),
                work: [0.0, size.finished as f64 * CASE_S, all],
                cases: BTreeMap::new(),
            });
        });
    }

    fn case_ended(&self, ended: &CaseEnded) {
        self.change(|now| {
            let Some(batch) = &mut now.batch else { return };
            (batch.ended, batch.of) = (batch.ended.max(ended.ended), ended.of);
            batch.work[0] += CASE_S + ended.reused_s;
            batch.work[1] += ended.reused_s;
            batch.update();
        });
    }
}
