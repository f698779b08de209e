//! A sweep whose cases a front end distributes.

use std::{fs, path::Path, sync::Arc};

use wholestring_case::{Override, Template, Variation};
use wholestring_results::Data;
use wholestring_runner::{
    BatchOptions, BatchOutcome, CancellationToken, Error, Existing, Output, Silent,
    sweep::{self, PreparedSweep, RemoteCase, Request},
};

/// Sweeps the straight slant from the tests of the command line with these values.
struct Swept {
    template: Arc<Template>,
    overrides: Vec<Override>,
    variations: Vec<Variation>,
    together: bool,
}

impl Swept {
    fn new(vary: &[&str], together: bool) -> Self {
        let template = Template::read(Path::new("../cli/tests/data/slant.toml"));
        let vary: Vec<String> = vary.iter().map(|vary| (*vary).to_owned()).collect();
        Self {
            template: Arc::new(template.expect("a case")),
            overrides: vec!["model=soft".parse().expect("an override")],
            variations: Variation::read_all(&vary).expect("values"),
            together,
        }
    }

    fn request(&self, folder: &Path, existing: Existing) -> Request<'_> {
        Request {
            template: &self.template,
            overrides: &self.overrides,
            variations: &self.variations,
            together: self.together,
            keep: None,
            batch: BatchOptions {
                output: Output { folder: Some(folder.to_owned()), existing, ..Output::default() },
                ..BatchOptions::default()
            },
        }
    }

    fn begin(&self, folder: &Path, existing: Existing) -> Result<PreparedSweep, Error> {
        let request = self.request(folder, existing);
        PreparedSweep::begin(&request, &Silent, &CancellationToken::new())
    }

    /// Solves one of its cases into a folder, as a worker does.
    fn solve(&self, hand: &PreparedSweep, case: usize, folder: &Path) -> sweep::Ended {
        let apart = RemoteCase {
            template: &self.template,
            changes: hand.changes(case),
            name: hand.name(case),
            options: hand.remote_options(),
        };
        apart.solve(folder, &Silent, &CancellationToken::new())
    }

    fn run(&self, folder: &Path) -> BatchOutcome {
        let request = self.request(folder, Existing::Resume);
        sweep::run(&request, &Silent, &CancellationToken::new()).expect("an outcome")
    }
}

fn table(folder: &Path) -> String {
    fs::read_to_string(folder.join(sweep::FILE)).expect("a table")
}

/// Solving here, in the folder by other processes, and elsewhere with files sent back gives the
/// same results. Cases finished in one way are not solved again in the other.
#[test]
fn cases_that_are_handed_out_are_those_of_the_sweep() {
    let place = tempfile::tempdir().expect("a folder");
    let swept = Swept::new(&["friction=0.1,0.2,0.3"], false);
    let (here, there) = (place.path().join("here"), place.path().join("there"));
    let token = CancellationToken::new();

    let mut hand = swept.begin(&there, Existing::Protect).expect("a sweep");
    assert!(matches!(swept.begin(&there, Existing::Resume), Err(Error::Folder(_))), "it is held");
    assert_eq!(hand.left().len(), 3);
    let folder = hand.make_ready(0).expect("a folder");
    let ended = swept.solve(&hand, 0, &folder);
    let sent = serde_json::to_vec(&ended).expect("bytes");
    hand.take(0, serde_json::from_slice(&sent).expect("the same"));
    let elsewhere = place.path().join("elsewhere");
    let ended = swept.solve(&hand, 1, &elsewhere);
    let summary = fs::read(elsewhere.join("summary.json")).expect("a summary");
    hand.put(1, &[("summary.json".to_owned(), summary)]).expect("put");
    hand.take(1, ended);
    for name in ["../summary.json", "a/b", "..", ""] {
        let refused = hand.put(2, &[(name.to_owned(), Vec::new())]);
        assert!(matches!(refused, Err(Error::BadInput(_))), "{name}");
    }
    token.cancel();
    let outcome = hand.end(&token).expect("an outcome");
    assert!(outcome.is_interrupted());
    assert_eq!((outcome.finished, outcome.all), (2, 3));
    drop(hand);

    let mut hand = swept.begin(&there, Existing::Resume).expect("the same sweep");
    assert_eq!(hand.left(), [2]);
    drop(hand);
    let written =
        || fs::metadata(folder.join("summary.json")).and_then(|metadata| metadata.modified()).ok();
    let before = written();
    assert_eq!(swept.run(&there).finished, 3);
    assert_eq!(written(), before);
    assert_eq!(swept.run(&here).finished, 3);
    assert_eq!(table(&here), table(&there));

    // Without resuming, all cases are solved again, and a case that is distributed twice only once.
    let mut hand = swept.begin(&there, Existing::Protect).expect("the same sweep");
    assert_eq!(hand.left().len(), 3);
    hand.make_ready(0).expect("a folder");
    assert!(written().is_none());
    let again = swept.solve(&hand, 0, &folder);
    let before = written();
    assert!(before.is_some() && !again.is_interrupted());
    let _ = swept.solve(&hand, 0, &folder);
    assert_eq!(written(), before);
}

#[test]
fn keys_that_are_varied_together_take_their_values_side_by_side() {
    let place = tempfile::tempdir().expect("a folder");
    let swept = Swept::new(&["friction=0.1,0.2", "bit_depth=500m,600m"], true);
    let hand = swept.begin(place.path(), Existing::Protect).expect("a sweep");
    let names: Vec<&str> = (0..hand.count()).map(|case| hand.name(case)).collect();
    assert_eq!(names, ["friction=0.1,bit_depth=500m", "friction=0.2,bit_depth=600m"]);
    let uneven = Swept::new(&["friction=0.1,0.2", "bit_depth=500m"], true);
    let refused = uneven.begin(&place.path().join("no"), Existing::Protect).err();
    let message = refused.expect("a refusal").to_string();
    assert!(message.contains("`friction` has 2 values and `bit_depth` has 1"), "{message}");
}

/// Varied keys are in SI if they are numbers, and every column has a meaning.
#[test]
fn the_table_is_read_back_with_numbers_and_units() {
    let place = tempfile::tempdir().expect("a folder");
    let vary = ["bit_depth=500m,1000ft", "operation.kind=trip_in,trip_out"];
    let outcome = Swept::new(&vary, false).run(place.path());
    assert_eq!(outcome.finished, 4);
    let (varied, table) = sweep::read(place.path()).expect("a table");
    assert_eq!(varied, 2);
    let depth = &table.columns()[0];
    assert_eq!(depth.unit, "m");
    let metres = Data::Number([500.0, 500.0, 304.8, 304.8].map(Some).to_vec());
    assert_eq!(depth.data, metres);
    assert!(matches!(table.columns()[1].data, Data::Text(_)));
    assert!(table.columns().iter().all(|column| !column.meaning.is_empty()));
    let loads = table.numbers("hook_load_N").expect("numbers");
    assert!(loads.iter().flatten().all(|load| *load > 0.0) && loads.len() == 4);
    assert_eq!(table.numbers("bit_depth_m").expect("numbers")[2], Some(304.8));
    assert!(sweep::read(&place.path().join("nothing")).is_err());
}
