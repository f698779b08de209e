//! The straight hole at 60 deg with its plain pipe, plans of it, and an observer that cancels them.

use std::{
    fs,
    path::Path,
    sync::atomic::{AtomicUsize, Ordering},
};

use wholestring_case::{Case, Override, Template};
use wholestring_runner::{
    BatchSize, CancellationToken, CaseEnded, Existing, Observer, Output, plan,
};

/// The case as it was read.
pub struct Slant {
    pub template: Template,
    pub overrides: Vec<Override>,
    pub case: Case,
}

impl Slant {
    /// The case with these keys changed.
    pub fn with(changes: &[&str]) -> Self {
        let overrides: Vec<Override> =
            changes.iter().map(|change| change.parse().expect("an override")).collect();
        let template = Template::read(Path::new("../cli/tests/data/slant.toml")).expect("a case");
        let case = template.case(&overrides).unwrap_or_else(|report| panic!("{report}"));
        Self { template, overrides, case }
    }

    /// A plan of it, solved by one job.
    pub fn plan(&self, folder: &Path, existing: Existing) -> plan::Request<'_> {
        plan::Request {
            case: &self.case,
            template: &self.template,
            overrides: &self.overrides,
            units: None,
            output: Output { folder: Some(folder.to_owned()), existing, ..Output::default() },
            jobs: std::num::NonZeroUsize::new(1),
            checkpoint_every: None,
            overlay: None,
            png: false,
        }
    }
}

/// Cancels after some tasks, and records how many were finished at the start.
pub struct Stops {
    after: usize,
    pub token: CancellationToken,
    finished: AtomicUsize,
}

impl Stops {
    pub fn after(tasks: usize) -> Self {
        Self { after: tasks, token: CancellationToken::new(), finished: AtomicUsize::new(0) }
    }

    /// Number of tasks that were finished at the start.
    pub fn finished(&self) -> usize {
        self.finished.load(Ordering::Relaxed)
    }
}

impl Observer for Stops {
    fn batch_started(&self, size: &BatchSize) {
        self.finished.store(size.finished, Ordering::Relaxed);
    }

    fn case_ended(&self, ended: &CaseEnded) {
        if ended.ended >= self.after {
            self.token.cancel();
        }
    }
}

/// Checks that files of two folders are equal.
pub fn same(names: &[&str], [a, b]: [&Path; 2]) {
    for name in names {
        let read = |folder: &Path| fs::read(folder.join(name)).expect("a file");
        assert!(read(a) == read(b), "{name}");
    }
}
