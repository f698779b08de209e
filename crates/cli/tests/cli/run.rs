//! A successful `run`: its output and its files.

use std::{collections::BTreeSet, f64::consts::PI, fs};

use crate::desk::{Desk, masked, transcript};
use insta::assert_snapshot;
use wholestring::outcome::ModelKind;
use wholestring_results::{Status, Summary, Table};

/// The soft string alone, which is quick.
pub(crate) const SOFT: [&str; 2] = ["--set", "model=soft"];

/// Files of a run without options.
pub(crate) const FILES: [&str; 8] = [
    ".wholestring",
    "contact.parquet",
    "nodes.parquet",
    "profile.svg",
    "report.html",
    "summary.json",
    "time.parquet",
    "wear.parquet",
];

pub(crate) fn files(desk: &Desk, folder: &str) -> BTreeSet<String> {
    fs::read_dir(desk.path(folder))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect()
}

/// The numbers of the snapshot are checked by `the_numbers_are_the_closed_forms`.
#[test]
fn soft_string_side_by_side() {
    let desk = Desk::new();
    let output = desk.run(&[&["run", "slant.toml"], &SOFT[..]].concat());
    assert_snapshot!(transcript(&output));
    assert_eq!(files(&desk, "out/Straight slant"), FILES.map(String::from).into());
}

#[test]
fn field_units_on_the_screen() {
    let desk = Desk::new();
    let output = desk.run(&[&["run", "slant.toml", "--units", "field"], &SOFT[..]].concat());
    assert_snapshot!(transcript(&output));
}

/// A straight slant: `F = w L (cos i + μ sin i)` tripping out, `M = μ r w L sin i` rotating.
#[test]
fn the_numbers_are_the_closed_forms() {
    let desk = Desk::new();
    desk.done(&[&["run", "slant.toml"], &SOFT[..]].concat());
    let summary = desk.summary("out/Straight slant");
    let weight_N =
        (7850.0 - 1200.0) * 9.80665 * PI / 4.0 * (0.12_f64.powi(2) - 0.08_f64.powi(2)) * 600.0;
    let (along_N, across_N) = (0.5 * weight_N, 0.75_f64.sqrt() * weight_N);
    let [trip_out, rotate] = &summary.operations[..] else {
        panic!("two operations");
    };
    // The equations are linear in depth here, so that only the rounding of some 600 steps remains.
    let close = |obtained: f64, expected: f64| {
        assert!((obtained / expected - 1.0).abs() < 1e-12, "{obtained} against {expected}");
    };
    close(trip_out.scalars.hook_load_N, along_N + 0.25 * across_N);
    close(trip_out.scalars.axial_friction_N, 0.25 * across_N);
    close(rotate.scalars.hook_load_N, along_N);
    close(rotate.scalars.surface_torque_N_m, 0.25 * 0.06 * across_N);
    close(rotate.scalars.side_force_total_N, across_N);
}

#[test]
fn soft_string_and_dynamics_side_by_side() {
    let desk = Desk::new();
    let output = desk.run(&["run", "slant.toml", "--csv", "-o", "here/and/there"]);
    assert_snapshot!(masked(&transcript(&output)));
    let expected = [
        ".wholestring",
        "contact.csv",
        "contact.parquet",
        "nodes.csv",
        "nodes.parquet",
        "profile.svg",
        "report.html",
        "summary.json",
        "time.csv",
        "time.parquet",
        "wear.csv",
        "wear.parquet",
    ];
    assert_eq!(files(&desk, "here/and/there"), expected.map(String::from).into());

    let summary = desk.summary("here/and/there");
    let solved: Vec<_> = summary
        .operations
        .iter()
        .map(|solved| (solved.model, solved.operation.name(), &solved.status))
        .collect();
    let done = &Status::Complete;
    assert_eq!(
        solved,
        [
            (ModelKind::Soft, "trip_out", done),
            (ModelKind::Dynamic, "trip_out", done),
            (ModelKind::Soft, "rotate_off_bottom", done),
            (ModelKind::Dynamic, "rotate_off_bottom", done),
        ]
    );
    for solved in &summary.operations {
        let dynamic = solved.model == ModelKind::Dynamic;
        assert_eq!(solved.statistics.is_some(), dynamic);
        assert_eq!(solved.numerics.is_some(), dynamic);
    }
    let statistics = summary.operations[1].statistics.as_ref().unwrap();
    let hook_load = statistics["hook_load_N"];
    assert_eq!(hook_load.mean, summary.operations[1].scalars.hook_load_N);

    check_climb(&desk.table("here/and/there/nodes.parquet"));

    let time = desk.table("here/and/there/time.parquet");
    // Two operations of 2 s, a row every 10 ms: the sampling interval is a whole number of steps,
    // so that it is 10 ms within half a step, which is 1.84 ms long.
    assert!((366..=441).contains(&time.rows()), "{} rows", time.rows());
    let times = time.numbers("time_s").expect("times");
    assert!((times[time.rows() - 1].unwrap() - 2.0).abs() < 0.02);
}

/// A string that rotates clockwise climbs to the right, to `atan 0.25`; a pulled one stays on the
/// low side. The soft string always lies there, in any operation, because its position follows its
/// load.
fn check_climb(nodes: &Table) {
    let [models, operations] = ["model", "operation"].map(|name| nodes.words(name).expect(name));
    let climb = nodes.numbers("climb_rad").expect("angles");
    let climbs_of = |model: &str, operation: &str| -> Vec<f64> {
        (0..nodes.rows())
            .filter(|row| models[*row] == model && operations[*row] == operation)
            .filter_map(|row| climb[row])
            .collect()
    };
    for operation in ["trip_out", "rotate_off_bottom"] {
        let climbs = climbs_of("soft", operation);
        assert!(climbs.len() > 600 && climbs.iter().all(|climb| *climb == 0.0), "{operation}");
    }
    let median = |operation: &str| {
        let mut values = climbs_of("dynamic", operation);
        values.sort_by(f64::total_cmp);
        values[values.len() / 2]
    };
    // After 2 s the initial transient still moves it by some hundredths.
    let (pulled, turned) = (median("trip_out"), median("rotate_off_bottom"));
    assert!(pulled.abs() < 0.05, "{pulled}");
    assert!((turned - 0.25_f64.atan()).abs() < 0.05, "{turned}");
}

#[test]
fn quiet_prints_nothing() {
    let desk = Desk::new();
    let output = desk.done(&[&["run", "slant.toml", "--quiet"], &SOFT[..]].concat());
    assert!(output.stdout.is_empty() && output.stderr.is_empty());
}

/// The case and the case with twice the elements, each in its folder, and the differences: the
/// weight of a straight string has none.
#[test]
fn converge_halves_every_element() {
    let desk = Desk::new();
    let case = ["run", "slant.toml", "--converge", "-o", "both", "--set", "dynamics.duration=1s"];
    let printed = transcript(&desk.done(&case));
    let [coarse, halved] = ["both", "both/halved"].map(|folder| desk.summary(folder));
    let elements =
        |summary: &Summary| summary.operations[1].numerics.as_ref().unwrap().run.elements;
    // A remainder shorter than all other elements may make one more or one less when halved.
    assert!(elements(&halved).abs_diff(2 * elements(&coarse)) <= 1);
    assert_eq!(coarse.settings["mesh"]["refinement"], serde_json::Value::Null);
    assert_eq!(halved.settings["mesh"]["refinement"], 2);
    let expected = format!("{} elements as given, {} halved", elements(&coarse), elements(&halved));
    let expected = format!("trip_out (dynamic): {expected}");
    assert!(printed.contains(&expected), "{printed}");
    let hook_load = printed.lines().filter(|line| line.starts_with("Hook load"));
    let changes: Vec<f64> = hook_load
        .skip(1)
        .map(|line| {
            let change = line.split(" %").next().unwrap().split_whitespace().last().unwrap();
            change.parse().unwrap_or_else(|_| panic!("{line}"))
        })
        .collect();
    assert_eq!(changes.len(), 2, "{printed}");
    assert!(changes.iter().all(|percent: &f64| percent.abs() < 0.1), "{printed}");
    assert!(printed.contains("\nResults with halved elements in both/halved\n"), "{printed}");
}

/// The stiff string has elements too.
#[test]
fn converge_halves_the_elements_of_the_stiff_string() {
    let desk = Desk::new();
    // Elements of a given length: automatic ones are refined where the solution requires it.
    let case = crate::desk::args(
        "run slant.toml --converge -o both --set model=stiff --set mesh.element_length=9.6m",
    );
    let printed = transcript(&desk.done(&case));
    let [coarse, halved] = ["both", "both/halved"].map(|folder| {
        let at_rest = desk.summary(folder).operations[0].at_rest;
        at_rest.expect("an equilibrium").convergence.elements
    });
    assert!(halved.abs_diff(2 * coarse) <= 1, "{coarse} {halved}");
    let title = format!("trip_out (stiff): {coarse} elements as given, {halved} halved");
    assert!(printed.contains(&title), "{printed}");
}

#[test]
fn converge_requires_elements() {
    let desk = Desk::new();
    let output = desk.run(&[&["run", "slant.toml", "--converge"], &SOFT[..]].concat());
    assert_snapshot!(transcript(&output));
    assert!(!desk.path("out").exists());
}
