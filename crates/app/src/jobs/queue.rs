//! The jobs of the folder: one runs, others wait, others have ended.

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
    job::{Ended, Job, State},
    prepared::{JobError, JobRequest, Prepared},
    progress::{Progress, Watcher},
};
use crate::workspace::{Workspace, WorkspaceError, millis};

/// Maximum number of waiting jobs; further requests are refused.
const WAITING: usize = 20;

/// Maximum number of ended jobs that are remembered; the oldest are forgotten. Their results stay.
const REMEMBERED: usize = 200;

/// The jobs of a folder.
#[derive(Debug)]
pub(crate) struct Jobs {
    workspace: Arc<Workspace>,
    inner: Mutex<Inner>,
    /// Signals a waiting job, or the end of the program.
    changed: Condvar,
}

#[derive(Debug, Default)]
struct Inner {
    /// Lock file while this server is the one that runs the jobs of the folder.
    hold: Option<File>,
    /// In the order of the requests, by id.
    entries: Vec<Entry>,
    worker: Option<JoinHandle<()>>,
    closing: bool,
}

/// A job with its state while the program runs.
#[derive(Debug)]
struct Entry {
    job: Job,
    /// Its inputs, until it starts.
    prepared: Option<Box<Prepared>>,
    /// Treatment of existing files in its folder at the next start.
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

    /// Notifies the followers of a change.
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
        // The steps under this lock leave a consistent state even after a panic.
        self.inner.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Saves a job's record; if it cannot be written, the work continues nevertheless.
    fn keep(&self, job: &Job) {
        if let Ok(bytes) = serde_json::to_vec(job) {
            let _ = self.workspace.keep_job(&job.id, &bytes);
        }
    }

    fn kept(&self) -> Vec<Job> {
        let records = self.workspace.kept_jobs();
        let mut jobs: Vec<Job> =
            records.iter().filter_map(|bytes| serde_json::from_slice(bytes).ok()).collect();
        jobs.sort_by(|a, b| (a.created_ms, &a.id).cmp(&(b.created_ms, &b.id)));
        jobs
    }

    /// Takes the lock on the folder's jobs, if no server holds it, and loads the unfinished jobs of
    /// an earlier server.
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
                State::Running => "the program ended during this job; its last checkpoint is kept",
                State::Waiting => "the program ended before the job started",
                _ => continue,
            };
            job.state = State::Interrupted;
            job.message = Some(message.to_owned());
            self.keep(job);
        }
        Ok(())
    }

    /// Every job with its progress, in the order of the requests.
    pub(crate) fn list(&self) -> Vec<(Job, Progress)> {
        let mut inner = self.lock();
        if inner.hold.is_none() && (!self.workspace.has_jobs() || self.hold(&mut inner).is_err()) {
            // Another server's jobs, as far as it has saved them.
            return self.kept().into_iter().map(|job| (job, Progress::default())).collect();
        }
        let entries = inner.entries.iter();
        entries.map(|entry| (entry.job.clone(), entry.progress.borrow().clone())).collect()
    }

    /// Returns a job with its progress.
    ///
    /// # Errors
    /// No job has the id.
    pub(crate) fn job(&self, id: &str) -> Result<(Job, Progress), JobError> {
        let inner = self.lock();
        if inner.hold.is_some() {
            let entry =
                inner.entries.iter().find(|entry| entry.job.id == id).ok_or_else(nothing)?;
            let progress = entry.progress.borrow().clone();
            return Ok((entry.job.clone(), progress));
        }
        drop(inner);
        let found = self.list().into_iter().find(|(job, _)| job.id == id);
        found.ok_or_else(nothing)
    }

    /// Returns a receiver of the changes of a job.
    ///
    /// # Errors
    /// No job of this server has the id.
    pub(crate) fn follow(&self, id: &str) -> Result<watch::Receiver<Progress>, JobError> {
        self.job(id)?;
        let inner = self.lock();
        let entry = inner.entries.iter().find(|entry| entry.job.id == id).ok_or_else(nothing)?;
        Ok(entry.progress.subscribe())
    }

    /// Queues work, and returns its id.
    ///
    /// # Errors
    /// Invalid work, too many waiting jobs, or another server that runs the jobs of this folder.
    pub(crate) fn start(self: &Arc<Self>, request: JobRequest) -> Result<String, JobError> {
        let prepared = Prepared::read(&request, &self.workspace)?;
        self.workspace.check_out()?;
        let mut inner = self.lock();
        self.hold(&mut inner)?;
        self.room(&inner)?;
        let job = Job {
            id: new_id()?,
            command: request.work.command().to_owned(),
            title: prepared.job.title().to_owned(),
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
        // A job that is not saved would be lost with the program.
        self.workspace.keep_job(&id, &bytes)?;
        let existing = job.request.if_there;
        inner.entries.push(Entry {
            prepared: Some(Box::new(prepared)),
            existing,
            ..Entry::of(job)
        });
        self.forget_old(&mut inner);
        self.wake(&mut inner)?;
        Ok(id)
    }

    /// Resumes a stopped job; one that cannot be continued starts again.
    ///
    /// # Errors
    /// As of [`Self::start`], and a job that is running or finished.
    pub(crate) fn resume(self: &Arc<Self>, id: &str) -> Result<(), JobError> {
        let (job, _) = self.job(id)?;
        if job.state.is_open() || job.state == State::Finished {
            return Err(JobError::Conflict(
                "the job cannot be resumed: it is running or finished".to_owned(),
            ));
        }
        let prepared = Prepared::read(&job.request, &self.workspace)?;
        self.workspace.check_out()?;
        let mut inner = self.lock();
        self.hold(&mut inner)?;
        self.room(&inner)?;
        let entry =
            inner.entries.iter_mut().find(|entry| entry.job.id == id).ok_or_else(nothing)?;
        if entry.job.state.is_open() {
            return Err(JobError::Conflict("the job is already running".to_owned()));
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

    /// Treatment of existing results when a job is resumed: from its partial results, if any.
    fn existing(&self, job: &Job) -> Existing {
        let folder = job.folder.as_ref().map(|path| self.workspace.root().join(path));
        let folder = folder.and_then(|path| self.workspace.inside(&path).ok());
        let is_there = folder.is_some_and(|path| match job.command.as_str() {
            // It continues from a checkpoint, and starts again without one.
            "run" => path.join("checkpoint.bin").is_file(),
            _ => true,
        });
        match job.request.work.is_resumable() && is_there {
            true => Existing::Resume,
            false if job.request.if_there == Existing::Overwrite => Existing::Overwrite,
            false => Existing::Protect,
        }
    }

    /// Stops a job; its computed results are kept.
    ///
    /// # Errors
    /// No job has the id, or it has ended.
    pub(crate) fn stop(&self, id: &str) -> Result<(), JobError> {
        let mut inner = self.lock();
        self.hold(&mut inner)?;
        let entry =
            inner.entries.iter_mut().find(|entry| entry.job.id == id).ok_or_else(nothing)?;
        match entry.job.state {
            State::Running => {
                entry.token.cancel();
            }
            State::Waiting => {
                entry.job.state = State::Stopped;
                entry.job.message = Some("stopped before it started".to_owned());
                entry.job.ended_ms = Some(now_ms());
                entry.prepared = None;
                self.keep(&entry.job);
                entry.tell();
            }
            _ => return Err(JobError::Conflict("it has ended already".to_owned())),
        }
        Ok(())
    }

    /// Forgets an ended job. Its results stay.
    ///
    /// # Errors
    /// No job has the id, or it is running.
    pub(crate) fn forget(&self, id: &str) -> Result<(), JobError> {
        let mut inner = self.lock();
        self.hold(&mut inner)?;
        let place =
            inner.entries.iter().position(|entry| entry.job.id == id).ok_or_else(nothing)?;
        if inner.entries[place].job.state.is_open() {
            return Err(JobError::Conflict("the job is running: stop it first".to_owned()));
        }
        inner.entries.remove(place);
        self.workspace.forget_job(id);
        Ok(())
    }

    /// Stops the running job, waits until its results are saved, and keeps the waiting ones.
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
        let waiting =
            inner.entries.iter().filter(|entry| entry.job.state == State::Waiting).count();
        match waiting < WAITING {
            true => Ok(()),
            false => Err(JobError::Conflict(format!(
                "{WAITING} jobs are waiting already: stop one, or wait until one has ended"
            ))),
        }
    }

    fn forget_old(&self, inner: &mut Inner) {
        while inner.entries.len() > REMEMBERED {
            let oldest = inner.entries.iter().position(|entry| !entry.job.state.is_open());
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

    /// Waits for a job and runs it; returns false once the program ends.
    fn work_once(&self) -> bool {
        let mut inner = self.lock();
        let (id, prepared, output, progress, token) = loop {
            if inner.closing {
                return false;
            }
            let next = inner.entries.iter_mut().find(|entry| entry.job.state == State::Waiting);
            if let Some(entry) = next
                && let Some(prepared) = entry.prepared.take()
            {
                (entry.job.state, entry.job.started_ms) = (State::Running, Some(now_ms()));
                entry.job.ended_ms = None;
                self.keep(&entry.job);
                entry.tell();
                let folder =
                    entry.job.folder.as_ref().map(|folder| self.workspace.root().join(folder));
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
        let work = || match prepared.job.execute(output, &watcher, &token) {
            Ok(outcome) => Ended::of(outcome),
            Err(error) => Ended::of_error(&error, root),
        };
        let ended = catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|_| Ended {
            folder: None,
            state: State::Failed,
            message: Some("internal error of the program".to_owned()),
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
        if let Some(entry) = inner.entries.iter_mut().find(|entry| entry.job.id == id) {
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

/// Sixteen random hexadecimal digits.
fn new_id() -> Result<String, JobError> {
    let mut bytes = [0; 8];
    getrandom::fill(&mut bytes).map_err(|error| bad(&error))?;
    Ok(bytes.iter().map(|byte| format!("{byte:02x}")).collect())
}
