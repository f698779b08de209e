//! Failures of `run`: refused, without an output folder, diverged, interrupted.

use std::{collections::BTreeSet, fs};

use crate::{
    desk::{Desk, args, transcript},
    run::SOFT,
};
use insta::assert_snapshot;
use wholestring_results::{CheckKind, OperationSummary, Status, Table};

#[test]
fn bad_input_leaves_no_folder() {
    let desk = Desk::new();
    let output = desk.run(&["run", "slant.toml", "--set", "bit_depth=60 bar"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(!desk.path("out").exists());
}

#[test]
fn a_file_in_the_place_of_the_folder() {
    let desk = Desk::new();
    assert_snapshot!(transcript(&desk.run(&["run", "slant.toml", "-o", "slant.toml"])));
}

#[test]
fn a_folder_in_the_place_of_a_file() {
    let desk = Desk::new();
    fs::create_dir_all(desk.path("results/nodes.parquet")).unwrap();
    let output = desk.run(&[&["run", "slant.toml", "-o", "results"], &SOFT[..]].concat());
    assert_eq!(output.status.code(), Some(3));
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(message.starts_with("error: cannot write"), "{message}");
    assert!(message.contains("nodes.parquet"), "{message}");
}

/// Two meganewtons on the bit lock a sliding pipe up. The soft string, which has no helix friction
/// here, and the other operation are solved nevertheless.
#[test]
fn without_an_equilibrium() {
    let desk = Desk::new();
    let output = desk.run(&args(
        "run slant.toml -o results --set 'model=[\"soft\", \"stiff\"]' \
         --set 'operation.kind=[\"slide\", \"trip_out\"]' --set 'operation.wob=2 MN'",
    ));
    assert_eq!(output.status.code(), Some(3));
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(message.contains("error: slide: the stiff string has no answer"), "{message}");
    assert!(message.contains("has no answer: Locks up:"), "{message}");
    let table = String::from_utf8(output.stdout).unwrap();
    assert!(table.contains("stiff*") && table.contains("Locks up:"), "{table}");

    let summary = desk.summary("results");
    let solved = |summary: &OperationSummary| summary.status == Status::Complete;
    let found: Vec<bool> = summary.operations.iter().map(solved).collect();
    assert_eq!(found, [true, false, true, true]);
    let stiff = &summary.operations[1];
    assert!(stiff.scalars.hook_load_N.is_nan());
    let kinds: Vec<CheckKind> = stiff.checks.iter().map(|check| check.kind).collect();
    assert_eq!(kinds, [CheckKind::LockUp]);
    let nodes = desk.table("results/nodes.parquet");
    let rows = nodes.words("operation").unwrap().iter().zip(nodes.words("model").unwrap());
    let solved: BTreeSet<String> = rows.map(|(row, model)| format!("{row} {model}")).collect();
    assert_eq!(solved, ["slide soft", "trip_out soft", "trip_out stiff"].map(Into::into).into());
    assert!(desk.path("results/report.html").is_file());
}

/// A lift of ten thousand tonnes throws the string out of the hole.
#[test]
fn diverged() {
    let desk = Desk::new();
    let output = desk.run(&args(
        "run slant.toml -o results --set hoist.control=hook-load \
         --set 'hoist.hook_load=1e8 N'",
    ));
    assert_eq!(output.status.code(), Some(3));
    let message = String::from_utf8(output.stderr).unwrap();
    // Such a hook load is surely unintended, which the first message reports.
    let parts = message.split_once("error: ");
    let (warning, message) = parts.unwrap_or_else(|| panic!("{message}"));
    assert!(warning.starts_with("warning: `hook_load` is unusually large"), "{warning}");
    assert!(message.starts_with("trip_out: the run diverged"), "{message}");
    assert!(message.ends_with("partial results are in results\n"), "{message}");
    let table = String::from_utf8(output.stdout).unwrap();
    assert!(
        table.contains("dynamic*") && table.contains("\n* as far as it was computed\n"),
        "{table}"
    );

    let summary = desk.summary("results");
    let [soft, dynamic] = &summary.operations[..] else {
        panic!("the run continues to the next operation");
    };
    assert_eq!(soft.status, Status::Complete);
    assert!(matches!(&dynamic.status, Status::Failed(reason) if message.contains(reason)));
    let time = desk.table("results/time.parquet");
    assert!(time.rows() > 0);
    // All numbers in a file are finite: JSON would have `null` where the contract has a number.
    let numerics = dynamic.numerics.as_ref().expect("a dynamic model");
    assert_eq!(
        (numerics.run.energy_residual, numerics.run.energy),
        (1.0, None),
        "a run that diverged balances nothing"
    );
    assert!(numerics.run.max_penetration_m.is_finite());
    let nodes = desk.table("results/nodes.parquet");
    let last = |table: &Table, name: &str| table.numbers(name)?.last().copied().flatten();
    for name in ["time_s", "hook_load_N", "surface_torque_N_m", "stretch_m"] {
        assert!(last(&time, name).is_some(), "{name}");
    }
    // The last row is the bit's, by the dynamic model.
    for name in ["md_m", "tension_N", "torque_N_m", "contact_force_N"] {
        assert!(last(&nodes, name).is_some(), "{name}");
    }
}

/// Ctrl-C keeps the computed results and reports them. Only Unix can send it to another process
/// from a test.
#[cfg(unix)]
#[test]
fn interrupted() {
    let desk = Desk::new();
    let endless = args("run slant.toml -o results --set 'dynamics.duration=3600 s'");
    // The soft string's results are written before the dynamics begin.
    let begun = || desk.path("results/summary.json").exists();
    assert_eq!(
        desk.interrupted(&endless, begun, std::time::Duration::from_millis(500)),
        "interrupted: partial results are in results\n\
         to continue, run the case with --resume results\n"
    );

    let summary = desk.summary("results");
    let statuses: Vec<_> = summary.operations.iter().map(|solved| &solved.status).collect();
    assert_eq!(statuses, [&Status::Complete, &Status::Interrupted]);
    let time = desk.table("results/time.parquet");
    assert!(time.rows() > 0);
}

/// A run that is stopped before its window begins has a profile of its samples until then.
#[test]
fn a_profile_without_window() {
    let desk = Desk::new();
    let output = desk.run(&args(
        "run slant.toml -o results --set model=dynamic --set 'dynamics.settle=100 s' \
         --set hoist.control=hook-load --set 'hoist.hook_load=1e8 N' \
         --set 'dynamics.sample_interval=1 ms'",
    ));
    assert_eq!(output.status.code(), Some(3));
    let nodes = desk.table("results/nodes.parquet");
    let tensions = nodes.numbers("tension_N").expect("tensions");
    // Ten thousand tonnes at the top.
    assert!(tensions[0].unwrap() > 1e6, "{:?}", tensions[0]);
}
