//! Parallel tasks whose outcomes are stored as they finish, so that the work can be resumed later.

use std::sync::Mutex;

use serde::{Deserialize, Serialize, de::DeserializeOwned};
use wholestring_results::{ResultsError, ResultsFolder};

use crate::{
    cancellation::CancellationToken,
    checkpoint::Keeper,
    observer::{BatchSize, CaseEnded, Observer},
    output::Existing,
    parallel::{in_parallel, lock},
};

/// Stored outcomes, and the identity of the work.
#[derive(Serialize, Deserialize)]
struct Stored<D> {
    identity: String,
    done: D,
}

/// Tasks, each with its outcome.
pub(crate) struct Tasks<'a, D> {
    identity: String,
    folder: &'a ResultsFolder,
    /// Outcome of each task, `None` until it is finished.
    done: Mutex<Vec<Option<D>>>,
    keeper: Mutex<Keeper<'a>>,
    observer: &'a dyn Observer,
    cancellation: &'a CancellationToken,
}

impl<'a, D: Clone + Send + Serialize + DeserializeOwned> Tasks<'a, D> {
    /// Creates `count` tasks of the work with this identity, without those finished earlier in its
    /// folder if the work is resumed.
    pub(crate) fn new(
        (count, identity): (usize, String),
        (folder, existing): (&'a ResultsFolder, Existing),
        keeper: Keeper<'a>,
        observer: &'a dyn Observer,
        cancellation: &'a CancellationToken,
    ) -> Result<Self, ResultsError> {
        let tasks = Self {
            identity,
            folder,
            done: Mutex::new(vec![None; count]),
            keeper: Mutex::new(keeper),
            observer,
            cancellation,
        };
        match existing {
            Existing::Resume => tasks.take_up(),
            Existing::Protect | Existing::Overwrite => folder.remove_checkpoint()?,
        }
        Ok(tasks)
    }

    /// Reads the outcomes of earlier work of the same identity.
    fn take_up(&self) {
        let stored = self.folder.read_checkpoint::<Stored<Vec<Option<D>>>>();
        let warning = match stored {
            Ok(None) => return,
            Ok(Some(stored)) if stored.identity != self.identity => {
                "it belongs to other inputs".to_owned()
            }
            Ok(Some(stored)) if stored.done.len() != self.count() => {
                "it has other tasks".to_owned()
            }
            Ok(Some(stored)) => {
                *lock(&self.done) = stored.done;
                return;
            }
            Err(error) => error.to_string(),
        };
        let place = self.folder.path().display();
        self.observer.warning(&format!("the checkpoint in {place} is not used: {warning}"));
    }

    /// Solves the remaining tasks in this order on `jobs` threads; a task that is cancelled before
    /// its end has no outcome.
    pub(crate) fn solve_all(
        &self,
        order: &[usize],
        jobs: usize,
        solve: impl Fn(usize) -> Option<D> + Sync,
    ) -> Result<(), ResultsError> {
        self.observer.batch_started(&BatchSize {
            cases: self.count(),
            finished: self.ended(),
            simulated_s: 0.0,
        });
        in_parallel(jobs, order, |task| self.solve(task, &solve));
        self.observer.batch_ended();
        if self.ended() < self.count() {
            return self.keep();
        }
        self.folder.remove_checkpoint()
    }

    fn solve(&self, task: usize, solve: &(impl Fn(usize) -> Option<D> + Sync)) {
        if lock(&self.done)[task].is_none() {
            if self.cancellation.is_cancelled() {
                return;
            }
            let Some(done) = solve(task) else {
                return;
            };
            lock(&self.done)[task] = Some(done);
            let is_due = lock(&self.keeper).is_due();
            if is_due && let Err(error) = self.keep() {
                // The work continues even if a checkpoint cannot be written, because the next one
                // may succeed.
                self.observer.warning(&format!("no checkpoint: {error}"));
            }
        }
        let (ended, count) = (self.ended(), self.count());
        self.observer.case_ended(&CaseEnded { ended, of: count, reused_s: 0.0 });
    }

    fn keep(&self) -> Result<(), ResultsError> {
        let mut keeper = lock(&self.keeper);
        let done = lock(&self.done);
        keeper.write(&Stored { identity: self.identity.clone(), done: &*done })
    }

    fn count(&self) -> usize {
        lock(&self.done).len()
    }

    /// Number of finished tasks.
    pub(crate) fn ended(&self) -> usize {
        lock(&self.done).iter().flatten().count()
    }

    /// Outcome of each task.
    pub(crate) fn into_done(self) -> Vec<Option<D>> {
        self.done.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner)
    }
}
