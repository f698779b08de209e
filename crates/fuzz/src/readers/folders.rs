//! Folders of results as input of `report` and `plot`: the output of each command, with one of its
//! files damaged, missing, or replaced by that of another command.

use std::{fs, path::Path, slice, sync::OnceLock};

use fastrand::Rng;
use serde_json::Value as Json;
use tempfile::TempDir;
use wholestring::outcome::ModelKind;
use wholestring_case::{Case, Override, Template, Variation};
use wholestring_results::{Column, Data, ResultsFolder, Table};
use wholestring_runner::{
    BatchOptions, CancellationToken, Output, Silent, bha, bit_test,
    calibrate::{self, NamedCase},
    modes, pictures, plan, reach, run, sweep, write_picture, write_report,
};
use wholestring_units::UnitSet;

use super::reader::{Make, New, Reader};
use crate::mutation;

/// The readers of this file.
pub(super) const READERS: &[(&str, New)] = &[
    ("folder-run", || folder("folder-run", run)),
    ("folder-sweep", || folder("folder-sweep", sweep)),
    ("folder-bha", || folder("folder-bha", bha)),
    ("folder-modes", || folder("folder-modes", modes)),
    ("folder-plan", || folder("folder-plan", plan)),
    ("folder-reach", || folder("folder-reach", reach)),
    ("folder-calibrate", || folder("folder-calibrate", calibrate)),
    ("folder-bit-test", || folder("folder-bit-test", bit_test)),
];

/// Files of a folder by their paths in it.
type Files = Vec<(String, Vec<u8>)>;

/// A command that writes its results to a folder.
type Command = fn(&Path);

/// A quick case for each command: a slant hole with plain pipe, its bit on weak rock in coarse
/// elements.
const CASE: &str = include_str!("../../../cli/tests/data/slant.toml");
const ROCK: &str = r#"
[bit.face]
cutter_diameter = "19 mm"
[rock]
strength = "10 MPa"
element_size = "15 mm"
density_factor = 60
[bit_test]
wob = "10 kN"
rpm = [240, 300]
settle_revolutions = 0.25
revolutions = 1
"#;

struct Slant {
    template: Template,
    overrides: Vec<Override>,
    case: Case,
}

impl Slant {
    fn with(more: &str, changes: &[&str]) -> Self {
        let overrides = changes.iter().map(|change| change.parse().expect("a change"));
        let overrides: Vec<Override> = overrides.collect();
        let template =
            Template::in_memory("slant.toml", &format!("{CASE}{more}"), Default::default());
        let case = template.case(&overrides).unwrap_or_else(|report| panic!("{report:?}"));
        Self { template, overrides, case }
    }
}

fn to(folder: &Path) -> Output {
    Output { folder: Some(folder.to_owned()), ..Output::default() }
}

fn batch(folder: &Path) -> BatchOptions {
    BatchOptions { output: to(folder), ..BatchOptions::default() }
}

fn run(folder: &Path) {
    let slant = Slant::with(
        "",
        &[
            "operation.kind=[\"trip_out\", \"drill\"]",
            "dynamics.settle=1 s",
            "dynamics.duration=2 s",
            "records.frames=5Hz",
        ],
    );
    let mut request = run::Request::new(&slant.case);
    request.output = to(folder);
    let done = run::run(&request, &Silent, &CancellationToken::new()).expect("a run");
    assert!(done.finished().is_ok());
}

fn sweep(folder: &Path) {
    let slant = Slant::with("", &["model=soft"]);
    let varied = ["friction=0.1,0.2".to_owned(), "bit_depth=300m,600m".to_owned()];
    let variations = Variation::read_all(&varied).expect("values");
    let request = sweep::Request {
        template: &slant.template.into(),
        overrides: &slant.overrides,
        variations: &variations,
        together: false,
        keep: None,
        batch: batch(folder),
    };
    let swept = sweep::run(&request, &Silent, &CancellationToken::new()).expect("a sweep");
    assert_eq!(swept.finished, 4);
}

fn bha(folder: &Path) {
    let slant = Slant::with("", &[]);
    let request = bha::Request { output: to(folder), ..bha::Request::new(&slant.case) };
    bha::run(&request, &Silent, &CancellationToken::new()).expect("an assembly");
}

fn modes(folder: &Path) {
    let slant = Slant::with("", &["modes.count=2"]);
    let request = modes::Request {
        case: &slant.case,
        operation: None,
        units: None,
        output: to(folder),
        png: false,
        jobs: None,
    };
    modes::run(&request, &Silent, &CancellationToken::new()).expect("modes");
}

fn plan(folder: &Path) {
    let slant = Slant::with("", &["plan.depths=3", "operation.kind=[\"trip_out\", \"drill\"]"]);
    let request = plan::Request {
        case: &slant.case,
        template: &slant.template,
        overrides: &slant.overrides,
        units: None,
        output: to(folder),
        jobs: None,
        checkpoint_every: None,
        overlay: None,
        png: false,
    };
    plan::run(&request, &Silent, &CancellationToken::new()).expect("a plan");
}

fn reach(folder: &Path) {
    let slant = Slant::with("", &[]);
    let request = reach::Request {
        case: &slant.case,
        template: &slant.template,
        overrides: &slant.overrides,
        from_m: None,
        to_m: Some(3000.0),
        frictions: Vec::new(),
        operations: Vec::new(),
        helix_side_force: true,
        stop_at_helix: false,
        units: None,
        output: to(folder),
        png: false,
        jobs: None,
    };
    reach::run(&request, &Silent, &CancellationToken::new()).expect("a reach");
}

fn calibrate(folder: &Path) {
    let slant = Slant::with("", &[]);
    let case = NamedCase {
        file: "slant.toml".to_owned(),
        template: &slant.template,
        overrides: &slant.overrides,
        case: &slant.case,
    };
    let request = calibrate::Request {
        cases: &[case],
        data: Path::new("slant-600-read.csv"),
        content: Some(include_bytes!("../../../cli/tests/data/slant-600-read.csv")),
        fit: calibrate::Fit {
            one_factor: false,
            by_section: false,
            friction_around: false,
            block_weight: false,
            bit_torque: false,
            hold: Vec::new(),
            errors: [None; 3],
            outlier_beyond: 3.0,
            without_outliers: false,
            band_confidence: 0.95,
            model: ModelKind::Soft,
        },
        check: None,
        units: None,
        output: to(folder),
        png: false,
    };
    calibrate::run(&request, &Silent, &CancellationToken::new()).expect("a calibration");
}

fn bit_test(folder: &Path) {
    let slant = Slant::with(ROCK, &[]);
    let request = bit_test::Request { case: &slant.case, units: None, batch: batch(folder) };
    bit_test::run(&request, &Silent, &CancellationToken::new()).expect("a bit test");
}

/// Returns the files of a command from which pages and pictures are made.
fn left_by(command: Command) -> Files {
    let place = tempfile::tempdir().expect("a folder for results");
    command(place.path());
    let mut files = Vec::new();
    let mut folders = vec![String::new()];
    while let Some(within) = folders.pop() {
        for entry in fs::read_dir(place.path().join(&within)).expect("a folder").flatten() {
            let name = format!("{within}{}", entry.file_name().to_string_lossy());
            if entry.path().is_dir() {
                folders.push(format!("{name}/"));
            } else if [".json", ".parquet", "sweep.csv"].iter().any(|end| name.ends_with(end)) {
                let bytes = fs::read(entry.path()).expect("a file");
                files.push((name, without_clock(bytes)));
            }
        }
    }
    files.sort();
    files
}

/// Removes wall-clock times from a file, so that inputs are reproducible.
fn without_clock(bytes: Vec<u8>) -> Vec<u8> {
    let Ok(mut value) = serde_json::from_slice::<Json>(&bytes) else { return bytes };
    stop_clock(&mut value);
    serde_json::to_vec(&value).expect("a value")
}

fn stop_clock(value: &mut Json) {
    match value {
        Json::Object(map) => {
            for (key, inner) in map {
                if matches!(key.as_str(), "wall_time_s" | "real_time_factor") {
                    *inner = 1.0.into();
                }
                stop_clock(inner);
            }
        }
        Json::Array(values) => values.iter_mut().for_each(stop_clock),
        _ => (),
    }
}

/// A table of another command than those with one of its name.
fn foreign() -> &'static [u8] {
    static BYTES: OnceLock<Vec<u8>> = OnceLock::new();
    BYTES.get_or_init(|| {
        let numbers = |name: &str| {
            let values = (0..50).map(|row| (row % 7 != 3).then_some(f64::from(row) * 0.1));
            Column::numbers(name, values.collect())
        };
        encoded(&Table::new(vec![
            Column::words("operation", (0..50).map(|row| format!("word {}", row % 3)).collect()),
            numbers("bit_depth_m"),
            numbers("md_m"),
        ]))
    })
}

fn folder(name: &'static str, command: Command) -> Reader {
    let files = left_by(command);
    let seed = postcard::to_allocvec(&files).expect("bytes");
    let scratch = tempfile::tempdir().expect("a folder for inputs");
    Reader {
        name,
        seeds: vec![seed],
        words: Vec::new(),
        make: Make::Own(Box::new(move |rng| {
            let files = damaged(&files, rng);
            postcard::to_allocvec(&files).expect("bytes")
        })),
        read: Box::new(move |input| match postcard::from_bytes(input) {
            Ok(files) => is_drawn(&scratch, &files),
            Err(_) => false,
        }),
    }
}

/// Whether page and pictures of a folder are drawn. A refusal has a reason, which must not be an
/// internal error.
fn is_drawn(scratch: &TempDir, files: &Files) -> bool {
    let folder = scratch.path().join("results");
    let _ = fs::remove_dir_all(&folder);
    for (name, bytes) in files {
        let path = folder.join(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(path, bytes).expect("the input is written");
    }
    fs::create_dir_all(&folder).expect("a folder");
    let is_explained = |error: String| {
        assert!(!error.contains("a mistake of the program"), "{error}");
        assert!(!error.trim().is_empty());
    };
    let units = [None, Some(UnitSet::Field)][files.len() % 2];
    let page = write_report(&folder, units).map_err(|error| is_explained(error.to_string()));
    match pictures(&[folder], units) {
        Ok(plots) => {
            let place = ResultsFolder::create(scratch.path().join("plots")).expect("a folder");
            for plot in plots {
                let written = write_picture(&place, &plot.name, &plot.figure, false);
                written.unwrap_or_else(|error| is_explained(error.to_string()));
            }
        }
        Err(error) => is_explained(error.to_string()),
    }
    page.is_ok()
}

/// The files with one or a few of them damaged.
fn damaged(files: &Files, rng: &mut Rng) -> Files {
    let mut files = files.clone();
    for _ in 0..1 + rng.usize(..2) * rng.usize(..3) {
        if files.is_empty() {
            break;
        }
        let at = rng.usize(..files.len());
        let other = files[rng.usize(..files.len())].1.clone();
        let (name, bytes) = &mut files[at];
        match rng.u8(..20) {
            0 => drop(files.remove(at)),
            1 => *bytes = other,
            2 if name.ends_with(".parquet") => *bytes = foreign().to_vec(),
            _ if name.ends_with(".parquet") => *bytes = damaged_table(bytes, rng),
            3 | 4 => {
                *bytes =
                    mutation::damaged(slice::from_ref(bytes), &["null", "1e300", "-1"], true, rng)
            }
            _ if name.ends_with(".json") => *bytes = damaged_json(bytes, rng),
            _ => {
                *bytes = mutation::damaged(slice::from_ref(bytes), &["1e300", "-1", ","], true, rng)
            }
        }
    }
    files
}

/// Numbers that no solver returns.
const NUMBERS: [f64; 12] =
    [0.0, -0.0, 1.0, -1.0, 1e300, -1e300, 1e-300, 5e-324, 1e20, -1e12, 1e6, 4e9];

fn decoded(bytes: &[u8]) -> Option<Table> {
    let place = tempfile::tempdir().ok()?;
    let path = place.path().join("table.parquet");
    fs::write(&path, bytes).ok()?;
    Table::read_parquet(&path).ok()
}

fn encoded(table: &Table) -> Vec<u8> {
    let place = tempfile::tempdir().expect("a folder");
    let path = place.path().join("table.parquet");
    table.write_parquet(&path).expect("a table is written");
    fs::read(path).expect("it is there")
}

/// A table with a column removed, of another kind or another name, with rows removed or reordered,
/// or with other numbers and words.
fn damaged_table(bytes: &[u8], rng: &mut Rng) -> Vec<u8> {
    let Some(table) = decoded(bytes) else {
        return bytes.to_vec();
    };
    let (mut columns, rows) = (table.columns().to_vec(), table.rows());
    if columns.is_empty() {
        return bytes.to_vec();
    }
    let at = rng.usize(..columns.len());
    match rng.u8(..9) {
        0 | 1 => drop(columns.remove(at)),
        2 => columns[at].name.push('x'),
        3 => {
            columns[at].data = match columns[at].data {
                Data::Number(_) => Data::Text(vec!["word".to_owned(); rows]),
                Data::Text(_) => Data::Number(vec![Some(1.0); rows]),
            };
        }
        4 => {
            let chosen_rows: Vec<usize> = (0..rows).filter(|_| rng.u8(..3) == 0).collect();
            chosen(&mut columns, &chosen_rows);
        }
        5 => {
            let mut order: Vec<usize> = (0..rows).collect();
            rng.shuffle(&mut order);
            chosen(&mut columns, &order);
        }
        _ => {
            let many = [1, 3, rows][rng.usize(..3)];
            for _ in 0..many.min(rows) {
                let row = rng.usize(..rows);
                match &mut columns[at].data {
                    Data::Number(values) => {
                        let known = rng.u8(..5) != 0;
                        values[row] = known.then(|| NUMBERS[rng.usize(..NUMBERS.len())]);
                    }
                    Data::Text(words) => {
                        words[row] = ["", "drill", "soft", "<b>&"][rng.usize(..4)].to_owned();
                    }
                }
            }
        }
    }
    encoded(&Table::new(columns))
}

fn chosen(columns: &mut [Column], rows: &[usize]) {
    for column in columns {
        match &mut column.data {
            Data::Number(values) => *values = rows.iter().map(|row| values[*row]).collect(),
            Data::Text(words) => *words = rows.iter().map(|row| words[*row].clone()).collect(),
        }
    }
}

/// A summary with values that are missing, duplicated or changed.
fn damaged_json(bytes: &[u8], rng: &mut Rng) -> Vec<u8> {
    let Ok(mut value) = serde_json::from_slice::<Json>(bytes) else {
        return bytes.to_vec();
    };
    for _ in 0..1 + rng.usize(..3) {
        change(&mut value, rng);
    }
    serde_json::to_vec(&value).expect("a value")
}

/// Descends from a value at random, and changes the value reached.
fn change(value: &mut Json, rng: &mut Rng) {
    match value {
        Json::Object(map) if !map.is_empty() => {
            let key = map.keys().nth(rng.usize(..map.len())).cloned().unwrap_or_default();
            if rng.u8(..24) == 0 {
                map.remove(&key);
            } else if let Some(inner) = map.get_mut(&key) {
                change(inner, rng);
            }
        }
        Json::Array(all) if !all.is_empty() => {
            let at = rng.usize(..all.len());
            match rng.u8(..24) {
                0 => drop(all.remove(at)),
                1 => all.push(all[at].clone()),
                2 => all.clear(),
                3 => all.reverse(),
                _ => change(&mut all[at], rng),
            }
        }
        Json::Number(_) if rng.u8(..6) != 0 => {
            *value = match rng.u8(..4) {
                0 => Json::from(rng.usize(..5)),
                _ => Json::from(NUMBERS[rng.usize(..NUMBERS.len())]),
            };
        }
        Json::String(_) if rng.u8(..3) != 0 => {
            *value = ["", "drill", "stiff", "failed", "<b>&"][rng.usize(..5)].into();
        }
        Json::Bool(is) => *is = !*is,
        _ => {
            *value =
                [Json::Null, 0.into(), "".into(), Json::Array(Vec::new())][rng.usize(..4)].clone()
        }
    }
}
