//! Interface for observers of running work.

use std::path::Path;

use wholestring_case::Report;

/// Receives events while cases are solved, for a progress bar, a log or a page.
///
/// By default each method does nothing. Cases of a batch are solved on several threads, which call
/// concurrently; a slow method delays the work.
pub trait Observer: Sync {
    /// Input that is valid but probably not intended.
    fn diagnostics(&self, _report: &Report) {}

    /// Useful information, such as a folder other than the expected one.
    fn note(&self, _text: &str) {}

    /// A problem that does not end the work, such as a checkpoint that cannot be written.
    fn warning(&self, _text: &str) {}

    /// The folder of the results, once it is locked.
    fn folder(&self, _path: &Path) {}

    /// Preparation before the first step of an operation: seconds, or minutes on rock.
    fn preparing(&self, _task: &Task<'_>, _what: &str) {}

    /// The preparation has ended.
    fn prepared(&self, _task: &Task<'_>) {}

    /// A simulation begins at the first time, or resumes there, and ends at the second at the
    /// latest, s.
    fn started(&self, _task: &Task<'_>, _from_s: f64, _end_s: f64) {}

    /// The simulation has reached a time.
    fn reached(&self, _task: &Task<'_>, _progress: &Progress) {}

    /// The simulation has ended, in whatever way.
    fn ended(&self, _task: &Task<'_>) {}

    /// The cases of a sweep or a study, or the points of a bit test, begin to be solved.
    fn batch_started(&self, _size: &BatchSize) {}

    /// One of them has ended.
    fn case_ended(&self, _of: &CaseEnded) {}

    /// All of them have ended.
    fn batch_ended(&self) {}
}

/// An observer without any output.
#[derive(Debug, Clone, Copy, Default)]
pub struct Silent;

impl Observer for Silent {}

/// A part of the work with its own simulated time.
#[derive(Debug, Clone, Copy)]
pub struct Task<'a> {
    /// Index of its case in the batch, or of its point; zero in a run.
    pub case: usize,
    /// Name of the operation as in the summary, or of the point.
    pub name: &'a str,
    /// Trial of a search for a setting, if it is one.
    pub trial: Option<Trial>,
}

/// A simulation in a search for a setting, such as the lift of a string at a given hook load.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Trial {
    /// Its number, from one.
    pub number: usize,
    /// Largest number of trials.
    pub most: usize,
}

/// Progress of a simulation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Progress {
    /// Simulated time reached, s.
    pub time_s: f64,
    /// End time, s; an upper limit while `settling`.
    pub end_s: f64,
    /// Whether it waits for a steady state.
    pub settling: bool,
}

/// Amount of work in a batch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BatchSize {
    /// Cases or points.
    pub cases: usize,
    /// Number of them known to be finished by an earlier batch.
    pub finished: usize,
    /// Simulated time of all of them, s; an upper limit.
    pub simulated_s: f64,
}

/// A case or point of a batch that has ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CaseEnded {
    /// Number that have ended by now.
    pub ended: usize,
    /// Total number.
    pub of: usize,
    /// Simulated time of this one that an earlier batch had solved, s.
    pub reused_s: f64,
}

/// The observer of one case.
#[derive(Clone, Copy)]
pub(crate) struct Watch<'a> {
    pub(crate) observer: &'a dyn Observer,
    /// Number of the case.
    pub(crate) case: usize,
}

impl<'a> Watch<'a> {
    /// Reports the preparation of an operation until the returned value is dropped.
    pub(crate) fn preparing(&self, name: &'a str, what: &str) -> Preparing<'a> {
        let preparation = Preparing(self.observer, self.task(name, None));
        self.observer.preparing(&preparation.1, what);
        preparation
    }

    /// Reports a simulation until the returned value is dropped.
    pub(crate) fn simulation(
        &self,
        name: &'a str,
        trial: Option<Trial>,
        [from_s, end_s]: [f64; 2],
    ) -> Simulating<'a> {
        let running = Simulating(self.observer, self.task(name, trial));
        self.observer.started(&running.1, from_s, end_s);
        running
    }

    fn task(&self, name: &'a str, trial: Option<Trial>) -> Task<'a> {
        let case = self.case;
        Task { case, name, trial }
    }
}

/// An operation in preparation.
pub(crate) struct Preparing<'a>(&'a dyn Observer, Task<'a>);

impl Drop for Preparing<'_> {
    fn drop(&mut self) {
        self.0.prepared(&self.1);
    }
}

/// A running simulation.
pub(crate) struct Simulating<'a>(&'a dyn Observer, Task<'a>);

impl Simulating<'_> {
    /// Reports its progress.
    pub(crate) fn reach(&self, time_s: f64, end_s: f64, settling: bool) {
        let progress = Progress { time_s, end_s, settling };
        self.0.reached(&self.1, &progress);
    }
}

impl Drop for Simulating<'_> {
    fn drop(&mut self) {
        self.0.ended(&self.1);
    }
}
