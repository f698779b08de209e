//! The jobs of the folder: one goes on, others wait, others have ended.

use std::{
    fs::File,
    panic::{AssertUnwindSafe, catch_unwind},
    path::Path,
    sync::{Arc, Condvar, Mutex, MutexGuard, OnceLock, PoisonError},
    thread::JoinHandle,
    time::SystemTime,
};

use tokio::sync::watch;
use wholestring_runner::{CancellationToken, Existing, Output};

use super::{
    carry_out::carry_out,
    ended::Ended,
    error::JobError,
    job::{Job, State},
    prepared::Prepared,
    progress::{Progress, Watcher},
    work::{IfThere, JobRequest},
};
use crate::workspace::{Workspace, WorkspaceError, millis};

/// Jobs that may wait; what is asked for beyond is refused.
const WAITING: usize = 20;

/// Jobs that have ended and are remembered; the oldest go. Their results stay.
const REMEMBERED: usize = 200;

/// The jobs of a folder.
#[derive(Debug)]
pub(crate) struct Jobs {
    workspace: Arc<Workspace>,
    inner: Mutex<Inner>,
    /// Something waits, or the program ends.
    changed: Condvar,
}

#[derive(Debug, Default)]
struct Inner {
    /// Held while this server is the one that does the work of the folder.
    hold: Option<File>,
    /// In the order in which they were asked for, by their ids.
    entries: Vec<Entry>,
    worker: Option<JoinHandle<()>>,
    closing: bool,
}

/// A job with what is known of it while the program runs.
#[derive(Debug)]
struct Entry {
    job: Job,
    /// What it needs, until it is begun.
    prepared: Option<Box<Prepared>>,
    /// What becomes of what lies in its folder, the next time.
    existing: Existing,
    progress: Arc<watch::Sender<Progress>>,
    token: CancellationToken,
}

impl Entry {
    fn of(job: Job) -> Self {
        Self {
            job,
            prepared: None,
            existing: Existing::Protect,
            progress: Arc::new(watch::Sender::new(Progress::default())),
            token: CancellationToken::new(),
        }
    }

    /// Tells those who follow it that something else is known of it.
    fn tell(&self) {
        self.progress.send_modify(|_| ());
    }
}

fn now_ms() -> u64 {
    millis(SystemTime::now())
}

const OTHER_SERVER: &str = "another `wholestring app` does the work of this folder: use its page";

impl Jobs {
    pub(crate) fn new(workspace: Arc<Workspace>) -> Arc<Self> {
        let (inner, changed) = (Mutex::default(), Condvar::new());
        Arc::new(Self { workspace, inner, changed })
    }

    fn lock(&self) -> MutexGuard<'_, Inner> {
        // What is done under it are steps that a panic does not leave half done.
        self.inner.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Keeps what is known of a job; where the disk is against it, the work goes on all the same.
    fn keep(&self, job: &Job) {
        if let Ok(bytes) = serde_json::to_vec(job) {
            let _ = self.workspace.keep_job(&job.id, &bytes);
        }
    }

    fn kept(&self) -> Vec<Job> {
        let kept = self.workspace.kept_jobs();
        let mut jobs: Vec<Job> =
            kept.iter().filter_map(|bytes| serde_json::from_slice(bytes).ok()).collect();
        jobs.sort_by(|a, b| (a.created_ms, &a.id).cmp(&(b.created_ms, &b.id)));
        jobs
    }

    /// Becomes the one that does the work of the folder, if nobody is, and learns what an earlier one
    /// has left unfinished.
    fn hold(&self, inner: &mut Inner) -> Result<(), JobError> {
        if inner.hold.is_some() {
            return Ok(());
        }
        let Some(hold) = self.workspace.hold_jobs()? else {
            return Err(JobError::Conflict(OTHER_SERVER.to_owned()));
        };
        inner.hold = Some(hold);
        inner.entries = self.kept().into_iter().map(Entry::of).collect();
        for Entry { job, .. } in &mut inner.entries {
            let message = match job.state {
                State::Running => {
                    "the program ended while it went on; what its last checkpoint holds is kept"
                }
                State::Waiting => "the program ended before its turn came",
                _ => continue,
            };
            job.state = State::Interrupted;
            job.message = Some(message.to_owned());
            self.keep(job);
        }
        Ok(())
    }

    /// Every job with how far it has come, in the order in which they were asked for.
    pub(crate) fn list(&self) -> Vec<(Job, Progress)> {
        let mut inner = self.lock();
        if inner.hold.is_none() && (!self.workspace.has_jobs() || self.hold(&mut inner).is_err()) {
            // Another server's, as far as it has kept them.
            return self.kept().into_iter().map(|job| (job, Progress::default())).collect();
        }
        let entries = inner.entries.iter();
        entries.map(|of| (of.job.clone(), of.progress.borrow().clone())).collect()
    }

    /// One of them.
    ///
    /// # Errors
    /// None has the id.
    pub(crate) fn job(&self, id: &str) -> Result<(Job, Progress), JobError> {
        let inner = self.lock();
        if inner.hold.is_some() {
            let entry = inner.entries.iter().find(|of| of.job.id == id).ok_or_else(nothing)?;
            let progress = entry.progress.borrow().clone();
            return Ok((entry.job.clone(), progress));
        }
        drop(inner);
        let found = self.list().into_iter().find(|(job, _)| job.id == id);
        found.ok_or_else(nothing)
    }

    /// What tells of each change of a job.
    ///
    /// # Errors
    /// None of this server has the id.
    pub(crate) fn follow(&self, id: &str) -> Result<watch::Receiver<Progress>, JobError> {
        self.job(id)?;
        let inner = self.lock();
        let entry = inner.entries.iter().find(|of| of.job.id == id).ok_or_else(nothing)?;
        Ok(entry.progress.subscribe())
    }

    /// Takes work on, and gives its id.
    ///
    /// # Errors
    /// Work that cannot be, too much that waits already, another server that does the work of this
    /// folder.
    pub(crate) fn start(self: &Arc<Self>, request: JobRequest) -> Result<String, JobError> {
        let prepared = Prepared::of(&request, &self.workspace)?;
        self.workspace.check_out()?;
        let mut inner = self.lock();
        self.hold(&mut inner)?;
        self.room(&inner)?;
        let job = Job {
            id: new_id()?,
            command: request.work.command().to_owned(),
            title: prepared.title.clone(),
            path: prepared.path.clone(),
            state: State::Waiting,
            created_ms: now_ms(),
            started_ms: None,
            ended_ms: None,
            folder: None,
            message: None,
            refusal: None,
            request,
        };
        let id = job.id.clone();
        let bytes = serde_json::to_vec(&job).map_err(|error| bad(&error))?;
        // What cannot be kept would be lost with the program.
        self.workspace.keep_job(&id, &bytes)?;
        let existing = match job.request.if_there {
            IfThere::Protect => Existing::Protect,
            IfThere::Resume => Existing::Resume,
            IfThere::Overwrite => Existing::Overwrite,
        };
        inner.entries.push(Entry {
            prepared: Some(Box::new(prepared)),
            existing,
            ..Entry::of(job)
        });
        self.forget_old(&mut inner);
        self.wake(&mut inner)?;
        Ok(id)
    }

    /// Goes on with a job that has stopped; what cannot be continued begins anew.
    ///
    /// # Errors
    /// As of [`Self::start`], and a job that goes on or has come to its end.
    pub(crate) fn resume(self: &Arc<Self>, id: &str) -> Result<(), JobError> {
        let (job, _) = self.job(id)?;
        if job.state.is_open() || job.state == State::Finished {
            return Err(JobError::Conflict("there is nothing left to go on with".to_owned()));
        }
        let prepared = Prepared::of(&job.request, &self.workspace)?;
        self.workspace.check_out()?;
        let mut inner = self.lock();
        self.hold(&mut inner)?;
        self.room(&inner)?;
        let entry = inner.entries.iter_mut().find(|of| of.job.id == id).ok_or_else(nothing)?;
        if entry.job.state.is_open() {
            return Err(JobError::Conflict("it goes on already".to_owned()));
        }
        entry.existing = self.existing(&entry.job);
        if entry.existing != Existing::Resume {
            entry.job.folder = None;
        }
        entry.prepared = Some(Box::new(prepared));
        entry.token = CancellationToken::new();
        entry.progress.send_replace(Progress::default());
        (entry.job.state, entry.job.message, entry.job.refusal) = (State::Waiting, None, None);
        self.keep(&entry.job);
        self.wake(&mut inner)
    }

    /// How a job goes on: from what it has left, where it has left something.
    fn existing(&self, job: &Job) -> Existing {
        let folder = job.folder.as_ref().map(|shown| self.workspace.root().join(shown));
        let folder = folder.and_then(|path| self.workspace.inside(&path).ok());
        let is_there = folder.is_some_and(|path| match job.command.as_str() {
            // It goes on from a checkpoint, and begins anew without one.
            "run" => path.join("checkpoint.bin").is_file(),
            _ => true,
        });
        match job.request.work.is_resumable() && is_there {
            true => Existing::Resume,
            false if job.request.if_there == IfThere::Overwrite => Existing::Overwrite,
            false => Existing::Protect,
        }
    }

    /// Stops a job; what it has computed is kept.
    ///
    /// # Errors
    /// None has the id, or it has ended.
    pub(crate) fn stop(&self, id: &str) -> Result<(), JobError> {
        let mut inner = self.lock();
        self.hold(&mut inner)?;
        let entry = inner.entries.iter_mut().find(|of| of.job.id == id).ok_or_else(nothing)?;
        match entry.job.state {
            State::Running => {
                entry.token.cancel();
            }
            State::Waiting => {
                entry.job.state = State::Stopped;
                entry.job.message = Some("stopped before its turn came".to_owned());
                entry.job.ended_ms = Some(now_ms());
                entry.prepared = None;
                self.keep(&entry.job);
                entry.tell();
            }
            _ => return Err(JobError::Conflict("it has ended already".to_owned())),
        }
        Ok(())
    }

    /// Forgets a job that has ended. Its results stay.
    ///
    /// # Errors
    /// None has the id, or it goes on.
    pub(crate) fn forget(&self, id: &str) -> Result<(), JobError> {
        let mut inner = self.lock();
        self.hold(&mut inner)?;
        let place = inner.entries.iter().position(|of| of.job.id == id).ok_or_else(nothing)?;
        if inner.entries[place].job.state.is_open() {
            return Err(JobError::Conflict("it goes on: stop it first".to_owned()));
        }
        inner.entries.remove(place);
        self.workspace.forget_job(id);
        Ok(())
    }

    /// Stops what goes on, waits until it has kept what it has computed, and keeps what waits.
    pub(crate) fn close(&self) {
        let worker = {
            let mut inner = self.lock();
            inner.closing = true;
            for entry in &inner.entries {
                entry.token.cancel();
            }
            inner.worker.take()
        };
        self.changed.notify_all();
        if let Some(worker) = worker {
            let _ = worker.join();
        }
    }

    fn room(&self, inner: &Inner) -> Result<(), JobError> {
        if inner.closing {
            return Err(JobError::Conflict("the program is about to end".to_owned()));
        }
        let waiting = inner.entries.iter().filter(|of| of.job.state == State::Waiting).count();
        match waiting < WAITING {
            true => Ok(()),
            false => Err(JobError::Conflict(format!(
                "{WAITING} jobs wait already: stop one, or wait until one has ended"
            ))),
        }
    }

    fn forget_old(&self, inner: &mut Inner) {
        while inner.entries.len() > REMEMBERED {
            let oldest = inner.entries.iter().position(|of| !of.job.state.is_open());
            let Some(oldest) = oldest else { return };
            let gone = inner.entries.remove(oldest);
            self.workspace.forget_job(&gone.job.id);
        }
    }

    fn wake(self: &Arc<Self>, inner: &mut Inner) -> Result<(), JobError> {
        if inner.worker.is_none() {
            let this = self.clone();
            let worker = std::thread::Builder::new().name("work".to_owned());
            let worker = worker.spawn(move || while this.work_once() {});
            inner.worker = Some(worker.map_err(|error| bad(&error))?);
        }
        self.changed.notify_all();
        Ok(())
    }

    /// Waits for a job and does it; false once the program ends.
    fn work_once(&self) -> bool {
        let mut inner = self.lock();
        let (id, prepared, output, progress, token) = loop {
            if inner.closing {
                return false;
            }
            let next = inner.entries.iter_mut().find(|of| of.job.state == State::Waiting);
            if let Some(entry) = next
                && let Some(prepared) = entry.prepared.take()
            {
                (entry.job.state, entry.job.started_ms) = (State::Running, Some(now_ms()));
                entry.job.ended_ms = None;
                self.keep(&entry.job);
                entry.tell();
                let folder = entry.job.folder.as_ref().map(|of| self.workspace.root().join(of));
                let root = self.workspace.root().to_owned();
                let output = Output { folder, existing: entry.existing, root };
                break (
                    entry.job.id.clone(),
                    prepared,
                    output,
                    entry.progress.clone(),
                    entry.token.clone(),
                );
            }
            inner = self.changed.wait(inner).unwrap_or_else(PoisonError::into_inner);
        };
        drop(inner);
        let at = |path: &Path| self.change(&id, |job| job.folder = self.workspace.shown(path));
        let watcher = Watcher { progress: &progress, at: &at, folder: OnceLock::new() };
        let root = self.workspace.root();
        let work = || carry_out(&prepared, output, &watcher, &token, root);
        let ended = catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|_| Ended {
            folder: None,
            state: State::Failed,
            message: Some("the program has met a mistake of its own".to_owned()),
            refusal: None,
        });
        watcher.end();
        self.end(&id, ended);
        true
    }

    fn end(&self, id: &str, ended: Ended) {
        let closing = self.lock().closing;
        let state = match ended.state {
            State::Stopped if closing => State::Interrupted,
            state => state,
        };
        self.change(id, |job| {
            if let Some(folder) = &ended.folder {
                job.folder = self.workspace.shown(folder);
            }
            (job.state, job.ended_ms) = (state, Some(now_ms()));
            (job.message, job.refusal) = (ended.message, ended.refusal);
        });
    }

    fn change(&self, id: &str, change: impl FnOnce(&mut Job)) {
        let mut inner = self.lock();
        if let Some(entry) = inner.entries.iter_mut().find(|of| of.job.id == id) {
            change(&mut entry.job);
            self.keep(&entry.job);
            entry.tell();
        }
    }
}

fn nothing() -> JobError {
    JobError::Workspace(WorkspaceError::Nothing("job"))
}

fn bad(error: &dyn std::fmt::Display) -> JobError {
    JobError::BadInput(error.to_string())
}

/// Sixteen hexadecimal digits that nobody else has.
fn new_id() -> Result<String, JobError> {
    let mut bytes = [0; 8];
    getrandom::fill(&mut bytes).map_err(|error| bad(&error))?;
    Ok(bytes.iter().map(|byte| format!("{byte:02x}")).collect())
}
