//! Overviews by case, computed by one thread in the background while there are cases to compute.

use std::{
    collections::{BTreeSet, HashMap, VecDeque},
    fs, io,
    panic::{AssertUnwindSafe, catch_unwind},
    path::{Component, Path},
    sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError},
    thread,
    time::{Duration, Instant, SystemTime},
};

use wholestring_case::{Case, Files, parse};
use wholestring_runner::CancellationToken;
use wholestring_screens::cases::Title;
use wholestring_units::UnitSet;

use super::compute::{CaseOverview, Silhouette, Solved};
use crate::workspace::{CaseFile, Workspace};

/// Number of new cases up to which a list waits for all names.
const FEW: usize = 8;

/// Time for which a list waits for the names of a few cases, and of many.
const WAIT: [Duration; 2] = [Duration::from_secs(2), Duration::from_millis(100)];

/// State of a file when it was read: size and time of the last change; `None` for a missing file.
type Stamp = Option<(u64, SystemTime)>;

/// The fingerprint of a case: of its own text, and the state of the files that it names.
#[derive(Debug, PartialEq)]
struct Fingerprint {
    revision: String,
    files: Vec<(String, Stamp)>,
}

impl Fingerprint {
    fn is_of(&self, revision: &str, case: &CaseFile) -> bool {
        self.revision == revision
            && self.files.iter().all(|(name, known)| stamp(case, name) == *known)
    }
}

fn stamp(case: &CaseFile, name: &str) -> Stamp {
    let about = fs::metadata(case.path.parent().unwrap_or(Path::new("")).join(name)).ok()?;
    Some((about.len(), about.modified().ok()?))
}

/// Files with a record of the names that are read, missing files included.
struct Named<F> {
    files: F,
    names: Mutex<BTreeSet<String>>,
}

impl<F: Files> Files for Named<F> {
    fn read(&self, name: &str) -> io::Result<Vec<u8>> {
        lock(&self.names).insert(name.to_owned());
        self.files.read(name)
    }
}

/// Data of a case that its text determines.
#[derive(Debug)]
pub(crate) struct Known {
    /// Name, first mistake and settings.
    pub(crate) title: Title,
    /// The well; `None` for an invalid case.
    pub(crate) silhouette: Option<Silhouette>,
    /// The answer; the outer option is `None` until it is computed.
    solved: Mutex<Option<Option<Solved>>>,
}

impl Known {
    /// Whether the answer is still to be computed.
    pub(crate) fn is_pending(&self) -> bool {
        lock(&self.solved).is_none()
    }

    /// The overview, with its sentence in these units; `None` without an answer.
    pub(crate) fn overview(&self, units: Option<UnitSet>) -> Option<CaseOverview> {
        let solved = lock(&self.solved);
        Some(solved.as_ref()?.as_ref()?.overview(units))
    }
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    // Values are replaced as a whole: a panic leaves none half written.
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[derive(Debug, Default)]
struct Queues {
    known: HashMap<String, (Fingerprint, Arc<Known>)>,
    /// Cases to read, with their revisions.
    to_read: VecDeque<(CaseFile, String)>,
    /// Cases to solve, after all are read.
    to_solve: VecDeque<(Arc<Known>, Case)>,
    is_running: bool,
}

#[derive(Debug)]
struct Shared {
    workspace: Arc<Workspace>,
    queues: Mutex<Queues>,
    has_read: Condvar,
    cancellation: CancellationToken,
}

/// The overviews of a folder.
#[derive(Debug)]
pub(crate) struct Overviews(Arc<Shared>);

impl Overviews {
    pub(crate) fn new(workspace: Arc<Workspace>) -> Self {
        Self(Arc::new(Shared {
            workspace,
            queues: Mutex::default(),
            has_read: Condvar::new(),
            cancellation: CancellationToken::new(),
        }))
    }

    /// Ends the work in the background.
    pub(crate) fn close(&self) {
        self.0.cancellation.cancel();
        let mut queues = lock(&self.0.queues);
        queues.to_read.clear();
        queues.to_solve.clear();
    }

    /// The data of these cases with their revisions; `None` for a case that is still to be read,
    /// which is begun.
    pub(crate) fn of(&self, cases: &[(&CaseFile, String)]) -> Vec<Option<Arc<Known>>> {
        let shared = &self.0;
        let mut queues = lock(&shared.queues);
        let is_fresh = |queues: &Queues, (case, revision): &(&CaseFile, String)| {
            queues.known.get(&case.id).is_some_and(|(print, _)| print.is_of(revision, case))
        };
        queues.known.retain(|id, _| cases.iter().any(|(case, _)| case.id == *id));
        // Only the cases of the newest list are read.
        let missing = cases.iter().filter(|one| !is_fresh(&queues, one));
        queues.to_read =
            missing.map(|(case, revision)| ((*case).clone(), revision.clone())).collect();
        let missing = queues.to_read.len();
        if missing > 0 && !queues.is_running {
            queues.is_running = true;
            let shared = shared.clone();
            thread::spawn(move || shared.work());
        }
        let end = Instant::now() + WAIT[usize::from(missing > FEW)];
        while !cases.iter().all(|one| is_fresh(&queues, one)) {
            let left = end.saturating_duration_since(Instant::now());
            if left.is_zero() || !queues.is_running {
                break;
            }
            let waited = shared.has_read.wait_timeout(queues, left);
            queues = waited.unwrap_or_else(PoisonError::into_inner).0;
        }
        let known = |one: &(&CaseFile, String)| {
            is_fresh(&queues, one).then(|| queues.known[&one.0.id].1.clone())
        };
        cases.iter().map(known).collect()
    }
}

impl Shared {
    fn work(&self) {
        loop {
            let mut queues = lock(&self.queues);
            if let Some((case, revision)) = queues.to_read.pop_front() {
                drop(queues);
                self.read(&case, revision);
            } else if let Some((known, case)) = queues.to_solve.pop_front() {
                drop(queues);
                // A case replaced meanwhile is held by nobody else.
                let solve = || Solved::of(case, &self.cancellation);
                let is_shown = Arc::strong_count(&known) > 1;
                let solved = is_shown.then(|| catch_unwind(AssertUnwindSafe(solve)).ok().flatten());
                *lock(&known.solved) = Some(solved.flatten());
            } else {
                queues.is_running = false;
                self.has_read.notify_all();
                return;
            }
        }
    }

    fn read(&self, case: &CaseFile, revision: String) {
        let (print, known, valid) = self.known(case, revision);
        let known = Arc::new(known);
        let mut queues = lock(&self.queues);
        queues.known.insert(case.id.clone(), (print, known.clone()));
        queues.to_solve.extend(valid.map(|case| (known, case)));
        self.has_read.notify_all();
    }

    fn known(&self, case: &CaseFile, revision: String) -> (Fingerprint, Known, Option<Case>) {
        let beside = Named { files: self.workspace.beside(case), names: Mutex::default() };
        let read = || match case.read() {
            Err(error) => (Title { problem: Some(error.to_string()), ..Title::default() }, None),
            Ok(read) => match parse(&case.shown, read.text.as_bytes(), &beside, &[]) {
                Err(_) => (Title::of(&case.shown, &read.text, &beside), None),
                Ok(valid) => {
                    let (name, settings) = (Some(valid.name.clone()), Some(valid.settings.clone()));
                    (Title { name, problem: None, settings }, Some(valid))
                }
            },
        };
        let failed = || (Title::default(), None);
        let (title, valid) = catch_unwind(AssertUnwindSafe(read)).unwrap_or_else(|_| failed());
        let silhouette = valid.as_ref().map(Silhouette::of);
        let is_inside = |name: &String| {
            Path::new(name).components().all(|part| matches!(part, Component::Normal(_)))
        };
        let names = lock(&beside.names).clone().into_iter().filter(is_inside);
        let files = names.map(|name| (name.clone(), stamp(case, &name)));
        let print = Fingerprint { revision, files: files.collect() };
        let solved = if valid.is_some() { None } else { Some(None) };
        (print, Known { title, silhouette, solved: Mutex::new(solved) }, valid)
    }
}
