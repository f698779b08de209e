//! Tasks that are done side by side and kept as they come, to go on with later.

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

/// What is kept of the work, and whose work it is.
#[derive(Serialize, Deserialize)]
struct Kept<D> {
    identity: String,
    done: D,
}

/// Tasks, each with what came of it.
pub(crate) struct Tasks<'a, D> {
    identity: String,
    folder: &'a ResultsFolder,
    /// What came of each task, none where nothing has yet.
    done: Mutex<Vec<Option<D>>>,
    keeper: Mutex<Keeper<'a>>,
    observer: &'a dyn Observer,
    cancellation: &'a CancellationToken,
}

impl<'a, D: Clone + Send + Serialize + DeserializeOwned> Tasks<'a, D> {
    /// So many tasks of the work with this identity, less what an earlier one has left in its folder,
    /// where that is to be continued.
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

    /// Takes up what earlier work of the same identity has finished.
    fn take_up(&self) {
        let kept = self.folder.read_checkpoint::<Kept<Vec<Option<D>>>>();
        let warning = match kept {
            Ok(None) => return,
            Ok(Some(kept)) if kept.identity != self.identity => "it is of another one".to_owned(),
            Ok(Some(kept)) if kept.done.len() != self.count() => "it has other tasks".to_owned(),
            Ok(Some(kept)) => {
                *lock(&self.done) = kept.done;
                return;
            }
            Err(error) => error.to_string(),
        };
        let place = self.folder.path().display();
        self.observer.warning(&format!("the checkpoint in {place} is left: {warning}"));
    }

    /// Solves what is left, in this order, so many at a time; what is cancelled before it has come to
    /// its end gives nothing.
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
                // The work does not end because one checkpoint cannot be written: the next may.
                self.observer.warning(&format!("no checkpoint: {error}"));
            }
        }
        let (ended, of) = (self.ended(), self.count());
        self.observer.case_ended(&CaseEnded { ended, of, reused_s: 0.0 });
    }

    fn keep(&self) -> Result<(), ResultsError> {
        let mut keeper = lock(&self.keeper);
        let done = lock(&self.done);
        keeper.write(&Kept { identity: self.identity.clone(), done: &*done })
    }

    fn count(&self) -> usize {
        lock(&self.done).len()
    }

    /// How many have ended.
    pub(crate) fn ended(&self) -> usize {
        lock(&self.done).iter().flatten().count()
    }

    /// What came of each.
    pub(crate) fn into_done(self) -> Vec<Option<D>> {
        self.done.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner)
    }
}
