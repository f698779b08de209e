//! The library from the view of a front end: events, cancellation, outcomes and refusals.

use std::{
    fs,
    path::Path,
    sync::{Arc, Mutex, PoisonError},
};

use wholestring_case::{Case, Override, Template, Variation};
use wholestring_results::{Status, Table};
use wholestring_runner::{
    BatchOptions, BatchSize, CancellationToken, CaseEnded, Error, Existing, FolderRefused,
    Observer, Output, Progress, Silent, Task, run, sweep,
};

/// The straight slant from the tests of the command line.
fn file() -> &'static Path {
    Path::new("../cli/tests/data/slant.toml")
}

fn slant(changes: &[&str]) -> Case {
    let changes: Vec<Override> =
        changes.iter().map(|change| change.parse().expect("an override")).collect();
    wholestring_case::load(file(), &changes).expect("a valid case")
}

fn request<'a>(case: &'a Case, folder: &Path, existing: Existing) -> run::Request<'a> {
    run::Request {
        output: Output { folder: Some(folder.to_owned()), existing, ..Output::default() },
        ..run::Request::new(case)
    }
}

/// Records the reported events, and cancels once a time is reached.
#[derive(Default)]
struct Log {
    lines: Mutex<Vec<String>>,
    cancels: Option<(f64, CancellationToken)>,
}

impl Log {
    fn add(&self, line: String) {
        let mut lines = self.lines.lock().unwrap_or_else(PoisonError::into_inner);
        // There are as many times as samples, so only the last is kept.
        if line.starts_with("reached")
            && lines.last().is_some_and(|line| line.starts_with("reached"))
        {
            lines.pop();
        }
        lines.push(line);
    }

    fn lines(self) -> Vec<String> {
        self.lines.into_inner().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Observer for Log {
    fn warning(&self, text: &str) {
        self.add(format!("warning {text}"));
    }

    fn preparing(&self, task: &Task<'_>, what: &str) {
        self.add(format!("preparing {}: {what}", task.name));
    }

    fn prepared(&self, task: &Task<'_>) {
        self.add(format!("prepared {}", task.name));
    }

    fn started(&self, task: &Task<'_>, from_s: f64, end_s: f64) {
        self.add(format!("started {}: {from_s:.1} to {end_s:.1}", task.name));
    }

    fn reached(&self, _: &Task<'_>, progress: &Progress) {
        self.add(format!("reached {:.1} of {:.1}", progress.time_s, progress.end_s));
        if let Some((time_s, token)) = &self.cancels
            && progress.time_s >= *time_s
        {
            token.cancel();
        }
    }

    fn ended(&self, task: &Task<'_>) {
        self.add(format!("ended {}", task.name));
    }

    fn batch_started(&self, size: &BatchSize) {
        self.add(format!("batch of {}", size.cases));
    }

    fn case_ended(&self, ended: &CaseEnded) {
        self.add(format!("{} of {}", ended.ended, ended.of));
    }

    fn batch_ended(&self) {
        self.add("batch ended".to_owned());
    }
}

#[test]
fn an_observer_is_told_of_every_operation() {
    let place = tempfile::tempdir().expect("a folder");
    let case = slant(&["model=dynamic"]);
    let request = request(&case, place.path(), Existing::Protect);
    let log = Log::default();
    let outcome = run::run(&request, &log, &CancellationToken::new()).expect("an outcome");
    let outcome = outcome.finished().expect("a finished run");
    assert_eq!(outcome.summary.operations.len(), 2);
    assert!(!outcome.is_resumable);
    let expected = ["trip_out", "rotate_off_bottom"].map(|name| {
        [
            format!("preparing {name}: initialising the string"),
            format!("prepared {name}"),
            format!("started {name}: 0.0 to 2.0"),
            "reached 2.0 of 2.0".to_owned(),
            format!("ended {name}"),
        ]
    });
    assert_eq!(log.lines(), expected.concat());
}

#[test]
fn a_cancelled_run_is_resumed_to_the_same_bytes() {
    let place = tempfile::tempdir().expect("a folder");
    let (whole, halted) = (place.path().join("whole"), place.path().join("halted"));
    let case = slant(&["model=dynamic", "operation.kind=trip_out"]);
    let go = |folder: &Path, existing, observer: &dyn Observer, token: &CancellationToken| {
        run::run(&request(&case, folder, existing), observer, token)
    };
    let never = CancellationToken::new();
    let outcome = go(&whole, Existing::Protect, &Silent, &never).expect("an outcome");
    assert!(outcome.stopped.is_none());

    let token = CancellationToken::new();
    let log = Log { cancels: Some((0.5, token.clone())), ..Log::default() };
    let outcome = go(&halted, Existing::Protect, &log, &token).expect("an outcome");
    assert_eq!(outcome.summary.operations[0].status, Status::Interrupted);
    assert!(outcome.is_resumable);
    assert!(matches!(outcome.finished(), Err(Error::Interrupted)));

    // Unfinished work is not replaced without a request.
    let again = go(&halted, Existing::Protect, &Silent, &never);
    assert!(matches!(again, Err(Error::Folder(FolderRefused::Unfinished { .. }))));
    let outcome = go(&halted, Existing::Resume, &Silent, &never).expect("an outcome");
    let outcome = outcome.finished().expect("a finished run");
    assert_eq!(outcome.summary.operations.len(), 1);
    for table in ["nodes.parquet", "time.parquet", "contact.parquet"] {
        let bytes = |folder: &Path| fs::read(folder.join(table)).expect("a table");
        assert!(bytes(&whole) == bytes(&halted), "{table}");
    }
}

#[test]
fn results_of_another_case_are_left_alone() {
    let place = tempfile::tempdir().expect("a folder");
    let go = |case: &Case, existing| {
        let request = request(case, place.path(), existing);
        run::run(&request, &Silent, &CancellationToken::new())
    };
    let (one, other) = (slant(&["model=soft"]), slant(&["model=soft", "friction=0.1"]));
    let outcome = go(&one, Existing::Protect).expect("an outcome");
    assert!(outcome.stopped.is_none());
    let refused = go(&other, Existing::Protect).expect_err("a refusal");
    assert!(matches!(refused, Error::Folder(FolderRefused::Occupied { .. })), "{refused}");
    let finished = go(&one, Existing::Resume).expect_err("nothing to resume");
    assert!(matches!(finished, Error::BadInput(_)));
    let outcome = go(&other, Existing::Overwrite).expect("an outcome");
    assert!(outcome.finished().is_ok());
}

/// A sweep of these friction factors.
fn swept(frictions: &str, folder: &Path, observer: &dyn Observer) -> Result<usize, Error> {
    let template = Arc::new(Template::read(file()).expect("a case file"));
    let variations = Variation::read_all(&[format!("friction={frictions}")]).expect("values");
    let request = sweep::Request {
        template: &template,
        overrides: &["model=soft".parse().expect("an override")],
        variations: &variations,
        together: false,
        keep: None,
        batch: BatchOptions {
            output: Output {
                folder: Some(folder.to_owned()),
                existing: Existing::Protect,
                ..Output::default()
            },
            ..BatchOptions::default()
        },
    };
    let outcome = sweep::run(&request, observer, &CancellationToken::new())?;
    Ok(outcome.finished()?.finished)
}

#[test]
fn an_observer_is_told_of_every_case() {
    let place = tempfile::tempdir().expect("a folder");
    let log = Log::default();
    let finished = swept("0.1,0.2,0.3", place.path(), &log);
    assert_eq!(finished.expect("a finished sweep"), 3);
    let expected = ["batch of 3", "1 of 3", "2 of 3", "3 of 3", "batch ended"];
    assert_eq!(log.lines(), expected);
    assert!(place.path().join(sweep::FILE).is_file());
}

#[test]
fn a_case_that_is_not_sound_is_named_before_any_is_solved() {
    let place = tempfile::tempdir().expect("a folder");
    let folder = place.path().join("sweep");
    let log = Log::default();
    let Err(Error::Unsound(unsound)) = swept("0.1,-0.2", &folder, &log) else {
        panic!("friction below zero is invalid");
    };
    assert_eq!(unsound.reports.len(), 1);
    let summary = "1 of 2 cases is invalid, friction=-0.2: nothing was run";
    assert_eq!(unsound.summary.as_deref(), Some(summary));
    assert!(log.lines().is_empty());
    assert!(!folder.exists());
}

/// Results in memory equal those that a run writes, and can be written later.
#[test]
fn answers_in_memory_are_those_of_a_run() {
    let place = tempfile::tempdir().expect("a folder");
    let case = slant(&["model=[\"soft\", \"dynamic\"]"]);
    let solved = run::answer(&case, None, &Silent, &CancellationToken::new()).expect("answers");
    assert!(solved.stopped.is_none());
    let ran = place.path().join("run");
    let outcome =
        run::run(&request(&case, &ran, Existing::Protect), &Silent, &CancellationToken::new());
    let outcome = outcome.expect("an outcome").finished().expect("a finished run");
    let answers = &solved.answers;
    let clocked = |summary: &wholestring_results::Summary| {
        let mut summary = summary.clone();
        for numerics in
            summary.operations.iter_mut().filter_map(|operation| operation.numerics.as_mut())
        {
            numerics.wall_time_s = 0.0;
            numerics.real_time_factor = 0.0;
        }
        summary
    };
    assert_eq!(clocked(answers.summary()), clocked(&outcome.summary));
    let output = Output { folder: Some(place.path().join("saved")), ..Output::default() };
    let saved = answers.save(&output, true, &Silent).expect("a folder");
    let names: Vec<&str> = answers.tables().iter().map(|(name, _)| *name).collect();
    assert_eq!(names, ["nodes", "time", "wear", "contact"]);
    for (name, table) in answers.tables() {
        let file = format!("{name}.parquet");
        assert!(Table::read_parquet(&ran.join(&file)).expect("a table") == *table, "{name}");
        assert!(Table::read_parquet(&saved.join(&file)).expect("a table") == *table, "{name}");
    }
    assert!(saved.join("report.html").is_file() && saved.join("nodes.csv").is_file());
    // Results of other cases are not replaced.
    let other = slant(&["model=soft", "name=other"]);
    let other = run::answer(&other, None, &Silent, &CancellationToken::new()).expect("answers");
    let refused = other.answers.save(&output, false, &Silent).expect_err("they are others");
    assert!(matches!(refused, Error::Folder(_)), "{refused}");
}

/// A front end that serves a folder puts `out` there, and receives the folder of the results before
/// the first answer.
#[test]
fn out_lies_where_it_is_said() {
    #[derive(Default)]
    struct Folders(Mutex<Vec<std::path::PathBuf>>);
    impl Observer for Folders {
        fn folder(&self, path: &Path) {
            assert!(!path.join("summary.json").is_file() || path.join(".wholestring").is_file());
            self.0.lock().expect("no panic").push(path.to_owned());
        }
    }
    let place = tempfile::tempdir().expect("a folder");
    let out = place.path().join("out");
    let folders = Folders::default();
    for changes in [["model=soft", "friction=0.2"], ["model=soft", "friction=0.3"]] {
        let case = slant(&changes);
        let mut request = run::Request::new(&case);
        request.output.root = place.path().to_owned();
        let outcome = run::run(&request, &folders, &CancellationToken::new()).expect("an outcome");
        let folder = outcome.finished().expect("a finished run").folder;
        assert!(folder.starts_with(&out), "{}", folder.display());
    }
    let folders = folders.0.into_inner().expect("no panic");
    let name = slant(&[]).name;
    assert_eq!(folders, [out.join(&name), out.join(format!("{name}-2"))]);
}

#[test]
fn frames_are_not_kept_in_memory() {
    let case = slant(&["model=dynamic", "records.frames=\"10 Hz\""]);
    let refused = run::answer(&case, None, &Silent, &CancellationToken::new());
    let Err(Error::BadInput(message)) = refused else { panic!("frames need a folder") };
    assert!(message.contains("folder"), "{message}");
}

/// A run that is advanced step by step equals the run of the case; a checkpoint of it, as bytes,
/// continues with bitwise equal results.
#[test]
fn a_live_run_is_the_run_of_the_case() {
    let case = Arc::new(slant(&["model=dynamic", "operation.kind=rotate_off_bottom"]));
    let (token, own) = (CancellationToken::new(), run::OwnLaws::default());
    let solved = run::answer(&case, None, &Silent, &token).expect("answers");
    let table = |answers: &run::Answers| {
        let tables = answers.tables();
        let time = tables.iter().find(|(name, _)| *name == "time").expect("a table");
        time.1.numbers("surface_torque_N_m").expect("numbers").to_vec()
    };
    let expected = table(&solved.answers);

    let mut live =
        run::Live::begin(case.clone(), None, &own, None, &Silent, &token).expect("a run");
    let end_s = live.simulation().end_time_s();
    live.advance(0.5 * end_s, &Silent, &token).expect("no divergence");
    let checkpoint = live.checkpoint().expect("bytes");
    let mut again = run::Live::resume(case.clone(), &own, None, &checkpoint).expect("the same run");
    for live in [&mut live, &mut again] {
        let left_s = end_s - live.simulation().time_s();
        live.advance(left_s, &Silent, &token).expect("no divergence");
        assert!(table(&live.answers()) == expected);
    }

    let other = Arc::new(slant(&["model=dynamic", "operation.kind=rotate_off_bottom", "rpm=61"]));
    let refused =
        run::Live::resume(other, &own, None, &checkpoint).err().expect("it is of another case");
    assert!(matches!(refused, Error::NotResumable { .. }), "{refused}");
    let mut damaged = checkpoint.clone();
    *damaged.last_mut().expect("a byte") ^= 1;
    assert!(matches!(
        run::Live::resume(case.clone(), &own, None, &damaged),
        Err(Error::Results(_))
    ));
    let refused = run::Live::begin(case.clone(), Some("fish"), &own, None, &Silent, &token).err();
    assert!(refused.expect("no operation").to_string().contains("it has rotate_off_bottom"));
    token.cancel();
    assert!(matches!(live.advance(1.0, &Silent, &token), Err(Error::Interrupted)));
    assert!(matches!(live.advance(-1.0, &Silent, &token), Err(Error::BadInput(_))));
}
