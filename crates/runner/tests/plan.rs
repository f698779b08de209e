//! A plan that is stopped goes on from where it was.

use std::{
    fs,
    path::Path,
    sync::{
        LazyLock,
        atomic::{AtomicUsize, Ordering},
    },
};

use wholestring_case::{Case, Override, Template};
use wholestring_runner::{
    BatchSize, CancellationToken, CaseEnded, Error, Existing, FolderRefused, Observer, Output,
    Silent, plan,
};

fn case() -> (Template, Vec<Override>, Case) {
    let changes = ["plan.depths=4", "operation.kind=[\"trip_out\"]"];
    let changes: Vec<Override> =
        changes.iter().map(|of| of.parse().expect("an override")).collect();
    let file = Path::new("../cli/tests/data/slant.toml");
    let template = Template::read(file).expect("a case");
    let case = template.case(&changes).expect("a sound case");
    (template, changes, case)
}

fn request<'a>(
    (template, overrides, case): &'a (Template, Vec<Override>, Case),
    folder: &Path,
    existing: Existing,
) -> plan::Request<'a> {
    plan::Request {
        case,
        template,
        overrides,
        units: None,
        output: Output { folder: Some(folder.to_owned()), existing },
        jobs: std::num::NonZeroUsize::new(1),
        checkpoint_every: None,
        png: false,
    }
}

/// Cancels after some pieces, and notes how many were finished when it began.
struct Stops {
    after: usize,
    token: CancellationToken,
    finished: AtomicUsize,
}

impl Stops {
    fn after(pieces: usize) -> Self {
        Self { after: pieces, token: CancellationToken::new(), finished: AtomicUsize::new(0) }
    }
}

impl Observer for Stops {
    fn batch_started(&self, size: &BatchSize) {
        self.finished.store(size.finished, Ordering::Relaxed);
    }

    fn case_ended(&self, of: &CaseEnded) {
        if of.ended >= self.after {
            self.token.cancel();
        }
    }
}

/// What was finished is kept, said to be missing where it is not, refused without being asked to go on,
/// and not solved again; in the end all files are as of a plan that nobody stopped.
#[test]
fn a_plan_that_is_stopped_goes_on() {
    let place = tempfile::tempdir().expect("a folder");
    let (whole, stopped) = (place.path().join("whole"), place.path().join("stopped"));
    let case = case();
    let token = CancellationToken::new();
    let done = plan::run(&request(&case, &whole, Existing::Protect), &Silent, &token);
    let done = done.expect("a plan");
    assert_eq!(done.batch.finished, done.batch.all);

    let stops = Stops::after(5);
    let request_of = |existing| request(&case, &stopped, existing);
    let first = plan::run(&request_of(Existing::Protect), &stops, &stops.token).expect("a part");
    assert!(first.batch.is_interrupted());
    assert_eq!(first.batch.finished, 5);
    assert!(first.summary.missing > 0);
    let page = fs::read_to_string(stopped.join("report.html")).expect("a page");
    assert!(page.contains("points are missing"));

    let refused = plan::run(&request_of(Existing::Protect), &Silent, &token);
    assert!(matches!(refused, Err(Error::Folder(FolderRefused::Unfinished { .. }))));

    let goes_on = Stops::after(usize::MAX);
    let second = plan::run(&request_of(Existing::Resume), &goes_on, &token).expect("the rest");
    assert_eq!(goes_on.finished.load(Ordering::Relaxed), 5);
    assert_eq!(second.summary, done.summary);
    for name in [
        "summary.json",
        "plan_broomstick.parquet",
        "plan_limits.csv",
        "plan_fatigue.csv",
        "plan_wear.csv",
        "report.html",
    ] {
        let read = |folder: &Path| fs::read(folder.join(name)).expect("a file");
        assert!(read(&whole) == read(&stopped), "{name}");
    }
    assert!(!stopped.join("checkpoint.bin").exists());
}
