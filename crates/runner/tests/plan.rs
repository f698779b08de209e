//! A plan that is stopped and resumed.

mod slant;

use std::fs;

use wholestring_runner::{CancellationToken, Error, Existing, FolderRefused, Silent, plan};

use slant::{Slant, Stops, same};
use wholestring::outcome::ModelKind;

/// An interrupted plan keeps finished tasks, reports the missing ones, is refused without a request
/// to resume, and does not solve finished tasks again; in the end all files equal those of an
/// uninterrupted plan.
#[test]
fn a_plan_that_is_stopped_goes_on() {
    let place = tempfile::tempdir().expect("a folder");
    let (whole, stopped) = (place.path().join("whole"), place.path().join("stopped"));
    let case = Slant::with(&["plan.depths=4", "operation.kind=[\"trip_out\"]"]);
    let token = CancellationToken::new();
    let done = plan::run(&case.plan(&whole, Existing::Protect), &Silent, &token);
    let done = done.expect("a plan");
    assert_eq!(done.batch.finished, done.batch.all);

    let stops = Stops::after(5);
    let request_of = |existing| case.plan(&stopped, existing);
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
    assert_eq!(goes_on.finished(), 5);
    assert_eq!(second.summary, done.summary);
    let names = [
        "summary.json",
        "plan_broomstick.parquet",
        "plan_limits.csv",
        "plan_fatigue.csv",
        "plan_wear.csv",
        "report.html",
    ];
    same(&names, [&whole, &stopped]);
    assert!(!stopped.join("checkpoint.bin").exists());
}

/// The dynamic part has its rows, its samples, its limits and its wear, on the page and in the
/// workbook too, and continues after an interruption.
#[test]
fn what_the_dynamics_is_asked_for() {
    let place = tempfile::tempdir().expect("a folder");
    let (whole, stopped) = (place.path().join("whole"), place.path().join("stopped"));
    let case = Slant::with(&[
        "plan.depths=2",
        "operation.kind=[\"trip_out\"]",
        "operation.flow_rate=\"1500 L/min\"",
        "rig.hoist_capacity=\"1000 kN\"",
        "mud.rheology=\"newtonian\"",
        "mud.viscosity=\"20 cP\"",
        "mud.gel_strength=\"10 Pa\"",
        "dynamics.settle=\"1 s\"",
        "dynamics.duration=\"1 s\"",
        "plan.campaign.off_bottom=\"10 h\"",
        "plan.dynamic.events=[\"pick_up_from_slips\", \"break_circulation\", \"break_rotation\"]",
        "plan.dynamic.wear=\"rotate_off_bottom\"",
        "plan.dynamic.watch=\"2 s\"",
        "plan.dynamic.pump_ramp=\"1 s\"",
    ]);
    let token = CancellationToken::new();
    let done = plan::run(&case.plan(&whole, Existing::Protect), &Silent, &token);
    let done = done.expect("a plan");
    let names: Vec<&str> = done.summary.peaks.iter().map(|peak| peak.event.as_str()).collect();
    assert_eq!(names, ["pick_up_from_slips", "break_circulation", "break_rotation"]);
    let [lifted, pumped, turned] = &done.summary.peaks[..] else { panic!("three events") };
    let hook = lifted.hook_load_N.expect("an answer");
    assert!(hook.peak > hook.at_rest && hook.peak >= hook.steady, "{hook:?}");
    assert!(lifted.surface_torque_N_m.is_none() && lifted.gel.is_none());
    assert!(pumped.gel.is_some() && pumped.pump_pressure_Pa.is_some());
    assert!(
        turned.surface_torque_N_m.is_some_and(|surface_torque_N_m| surface_torque_N_m.peak > 0.0)
    );
    let of_events = |kind: &str| {
        let limits = done.summary.checks.iter();
        limits
            .filter(|row| row.model == ModelKind::Dynamic && row.check.kind.name() == kind)
            .count()
    };
    assert_eq!(of_events("hoist"), 3);
    assert!(done.summary.wear.iter().any(|wear| wear.model == ModelKind::Dynamic));
    let page = fs::read_to_string(whole.join("report.html")).expect("a page");
    for expected in
        ["Setting in motion", "pick-up from slips, dynamics", "plan_peaks.csv", "peaks.csv"]
    {
        assert!(page.contains(expected), "{expected}");
    }
    assert!(whole.join("peaks.svg").is_file());

    let stops = Stops::after(2);
    let request_of = |existing| case.plan(&stopped, existing);
    let first = plan::run(&request_of(Existing::Protect), &stops, &stops.token).expect("a part");
    assert!(first.batch.is_interrupted());
    let second = plan::run(&request_of(Existing::Resume), &Silent, &token).expect("the rest");
    assert_eq!(second.summary, done.summary);
    let names = [
        "summary.json",
        "plan_peaks.csv",
        "plan_peaks_time.parquet",
        "plan_limits.csv",
        "plan_wear.csv",
        "report.html",
    ];
    same(&names, [&whole, &stopped]);
    // A plan without dynamics leaves no files of them.
    let plain = Slant::with(&["plan.depths=2", "operation.kind=[\"trip_out\"]"]);
    plan::run(&plain.plan(&whole, Existing::Overwrite), &Silent, &token).expect("a plan");
    for name in ["plan_peaks.csv", "plan_peaks_time.parquet", "peaks.csv", "peaks.svg"] {
        assert!(!whole.join(name).exists(), "{name}");
    }
}
