//! What an observer of the work learns while it goes on.

use std::path::Path;

use wholestring_case::Report;

/// Learns what happens while cases are solved: a progress bar, a log, a page that follows.
///
/// Every method does nothing unless it is written. Cases of a batch are solved on several threads,
/// which call at the same time; a method that takes long holds the work up.
pub trait Observer: Sync {
    /// Input that is valid, but probably does not say what was meant.
    fn diagnostics(&self, _report: &Report) {}

    /// Something that is good to know, such as another folder than the expected one.
    fn note(&self, _text: &str) {}

    /// Something that went wrong and does not end the work, such as a checkpoint that cannot be
    /// written.
    fn warning(&self, _text: &str) {}

    /// The folder that the results go to, once it is held.
    fn folder(&self, _path: &Path) {}

    /// What is done before the first step of an operation: seconds, or minutes on rock.
    fn preparing(&self, _task: &Task<'_>, _what: &str) {}

    /// That is done.
    fn prepared(&self, _task: &Task<'_>) {}

    /// A simulation begins at this time, or is resumed there, and ends at this one at the latest,
    /// s.
    fn started(&self, _task: &Task<'_>, _from_s: f64, _end_s: f64) {}

    /// It has reached a time.
    fn reached(&self, _task: &Task<'_>, _progress: &Progress) {}

    /// It has ended, however it did.
    fn ended(&self, _task: &Task<'_>) {}

    /// The cases of a sweep or a study, or the points of a bit test, begin to be solved.
    fn batch_started(&self, _size: &BatchSize) {}

    /// One of them has ended.
    fn case_ended(&self, _of: &CaseEnded) {}

    /// All of them have.
    fn batch_ended(&self) {}
}

/// An observer that keeps everything to itself.
#[derive(Debug, Clone, Copy, Default)]
pub struct Silent;

impl Observer for Silent {}

/// A piece of work with a simulated time of its own.
#[derive(Debug, Clone, Copy)]
pub struct Task<'a> {
    /// Number of its case in the batch, or of its point, counted from zero; zero in a run.
    pub case: usize,
    /// The operation as the summary names it, or the point.
    pub name: &'a str,
    /// Which trial of a search it is, where it only serves to find a setting.
    pub trial: Option<Trial>,
}

/// A simulation that serves to find a setting, such as the lift of a string that hangs on a hook
/// load.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Trial {
    /// Its number, from one.
    pub number: usize,
    /// How many there may be at most.
    pub most: usize,
}

/// How far a simulation has come.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Progress {
    /// Simulated time reached, s.
    pub time_s: f64,
    /// When it will end, s; at the latest while it is `settling`.
    pub end_s: f64,
    /// Whether it waits for a steady state.
    pub settling: bool,
}

/// How much there is to do in a batch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BatchSize {
    /// Cases or points.
    pub cases: usize,
    /// Those of them that an earlier batch has finished, as far as that is known.
    pub finished: usize,
    /// Simulated time of all of them, s, at most.
    pub simulated_s: f64,
}

/// A case of a batch that has ended, or a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CaseEnded {
    /// How many have ended by now.
    pub ended: usize,
    /// How many there are.
    pub of: usize,
    /// Simulated time of this one that was not solved now, because an earlier batch had, s.
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
    /// Shows what is done before an operation's first step, until what it gives is dropped.
    pub(crate) fn preparing(&self, name: &'a str, what: &str) -> Preparing<'a> {
        let shown = Preparing(self.observer, self.task(name, None));
        self.observer.preparing(&shown.1, what);
        shown
    }

    /// Reports a simulation, until what it gives is dropped.
    pub(crate) fn simulation(
        &self,
        name: &'a str,
        trial: Option<Trial>,
        [from_s, end_s]: [f64; 2],
    ) -> Simulating<'a> {
        let shown = Simulating(self.observer, self.task(name, trial));
        self.observer.started(&shown.1, from_s, end_s);
        shown
    }

    fn task(&self, name: &'a str, trial: Option<Trial>) -> Task<'a> {
        let case = self.case;
        Task { case, name, trial }
    }
}

/// An operation that is prepared.
pub(crate) struct Preparing<'a>(&'a dyn Observer, Task<'a>);

impl Drop for Preparing<'_> {
    fn drop(&mut self) {
        self.0.prepared(&self.1);
    }
}

/// A simulation that goes on.
pub(crate) struct Simulating<'a>(&'a dyn Observer, Task<'a>);

impl Simulating<'_> {
    /// Shows how far it has come.
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
