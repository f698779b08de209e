//! How far a job has come, as its observer learns it.

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

/// Notes and warnings that are kept of a job.
const NOTES: usize = 100;

/// Checks that are listed of a job; its results have all.
const FINDINGS: usize = 20;

/// How far a job has come.
#[derive(Debug, Clone, Default, Serialize, ToSchema)]
pub(crate) struct Progress {
    /// What goes on now: operations, or cases of a sweep.
    pub(crate) bars: Vec<Bar>,
    /// Cases, points or samples, where there are many.
    pub(crate) batch: Option<Batch>,
    /// What is good to know.
    pub(crate) notes: Vec<String>,
    /// What went wrong and did not end the work, and input that probably is not what was meant.
    pub(crate) warnings: Vec<String>,
    /// What was found in the operations that have ended, the most severe first.
    pub(crate) checks: Vec<Found>,
}

/// An operation that goes on.
#[derive(Debug, Clone, Serialize, ToSchema)]
pub(crate) struct Bar {
    /// The number of its case, and its name.
    #[serde(skip)]
    key: (usize, String),
    /// What it is: `trip out`, `slide, lift 2 of at most 9`.
    title: String,
    /// What is done before its time begins; none once that runs.
    preparing: Option<String>,
    /// Simulated time that it has reached, s.
    reached_s: f64,
    /// Simulated time at which it ends, at the latest while it settles, s.
    end_s: f64,
    /// Whether it waits for a steady state.
    settling: bool,
    /// Wall-clock time until it ends, at the pace until now, s.
    left_s: Option<f64>,
    #[serde(skip)]
    began: Instant,
    #[serde(skip)]
    from_s: f64,
}

/// Cases, points or samples.
#[derive(Debug, Clone, Serialize, ToSchema)]
pub(crate) struct Batch {
    /// How many there are.
    of: usize,
    /// How many have ended.
    ended: usize,
    /// How much of the work is done, from 0 to 1.
    part: f64,
    /// Wall-clock time until the end, at the pace until now, s.
    left_s: Option<f64>,
    #[serde(skip)]
    began: Instant,
    /// Work in simulated seconds and thousandths of a case: done, at the beginning, and in all.
    #[serde(skip)]
    work: [f64; 3],
    #[serde(skip)]
    cases: BTreeMap<usize, [f64; 2]>,
}

/// A case counts as this much simulated time besides its own, s: soft strings move the bar too.
const CASE_S: f64 = 1e-3;

impl Batch {
    fn update(&mut self) {
        let [done, before, all] = self.work;
        self.part = if all > 0.0 { (done / all).clamp(0.0, 1.0) } else { 1.0 };
        self.left_s = left_s(self.began, done - before, all - done);
    }
}

/// Wall-clock time for what is left, at the pace of what was done since.
fn left_s(since: Instant, done: f64, left: f64) -> Option<f64> {
    let is_known = done > 0.0 && left >= 0.0;
    is_known.then(|| since.elapsed().as_secs_f64() * left / done).filter(|left| left.is_finite())
}

/// Tells those who follow a job how far it has come; they get the latest state, not each.
pub(super) struct Watcher<'a> {
    pub(super) progress: &'a watch::Sender<Progress>,
    /// Told of the folder of the results once it is held.
    pub(super) at: &'a (dyn Fn(&Path) + Sync),
    pub(super) folder: OnceLock<PathBuf>,
}

impl Watcher<'_> {
    /// Reads what was found until now: it is written as each operation ends.
    fn look(&self) {
        if let Some(folder) = self.folder.get() {
            let mut found = checks(folder);
            found.truncate(FINDINGS);
            self.change(|now| now.checks = found);
        }
    }

    /// Nothing goes on any more.
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
                // It is shorter than it was thought to be.
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

    fn case_ended(&self, of: &CaseEnded) {
        self.change(|now| {
            let Some(batch) = &mut now.batch else { return };
            (batch.ended, batch.of) = (batch.ended.max(of.ended), of.of);
            batch.work[0] += CASE_S + of.reused_s;
            batch.work[1] += of.reused_s;
            batch.update();
        });
    }
}
