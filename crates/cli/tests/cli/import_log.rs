//! From a rig's log file to friction.

#[path = "../../../import/tests/rig_log/mod.rs"]
#[allow(dead_code, reason = "other tests have more of it")]
mod rig_log;

use std::{fs, path::Path};

use insta::assert_snapshot;
use rig_log::{Manner, Rig, Truth};
use wholestring::{
    operation::{Operation, OperationKind},
    statics::soft::soft_string,
};
use wholestring_results::CalibrationSummary;

use crate::desk::{Desk, transcript};

/// Bit depths at which the soft string is solved; weights are interpolated linearly between them.
const FROM_M: f64 = 300.0;
const STEP_M: f64 = 20.0;
const STEPS: usize = 45;

/// Values at even steps, with linear interpolation between them.
fn lines(values: Vec<f64>) -> Box<dyn Fn(f64) -> f64> {
    Box::new(move |at_m| {
        let place = ((at_m - FROM_M) / STEP_M).clamp(0.0, (values.len() - 2) as f64);
        let below = place as usize;
        values[below] + (place - below as f64) * (values[below + 1] - values[below])
    })
}

/// The shipped slant well, tripped out and in and drilled; its friction is 0.2 in casing and 0.3 in
/// open hole. The noise is a hundredth of the weights.
fn slant_log(desk: &Desk) -> String {
    let case = wholestring_case::load(&desk.path("slant-well.toml"), &[]).unwrap();
    let setup = case.setup();
    let models: Vec<_> =
        (0..=STEPS).map(|step| setup.at(FROM_M + STEP_M * step as f64).unwrap()).collect();
    let load = |kind: OperationKind, torque: bool| {
        let operation = case.operations.iter().find(|operation| operation.kind == kind).unwrap();
        let at = |(step, model): (usize, &_)| {
            let bit_depth_m = FROM_M + STEP_M * step as f64;
            let scalars =
                soft_string(model, &Operation { bit_depth_m, ..*operation }).unwrap().scalars;
            if torque { scalars.surface_torque_N_m } else { scalars.hook_load_N }
        };
        lines(models.iter().enumerate().map(at).collect())
    };
    let truth = Truth {
        pick_up_N: load(OperationKind::TripOut, false),
        slack_off_N: load(OperationKind::TripIn, false),
        rotating_N: load(OperationKind::RotateOffBottom, false),
        torque_N_m: load(OperationKind::RotateOffBottom, true),
        torque_on_bottom_N_m: load(OperationKind::Drill, true),
    };
    let noise = (4e3, 200.0);
    let manner = Manner {
        step_s: 2.0,
        weight_noise_N: noise.0,
        torque_noise_N_m: noise.1,
        ..Manner::default()
    };
    let mut rig = Rig::new(manner, truth, 1080.0, 1080.0);
    rig.trips_out(16);
    rig.trips_in(16);
    for _ in 0..3 {
        rig.drills_a_stand();
    }
    rig.las()
}

fn desk() -> Desk {
    let desk = Desk::new();
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slant.toml");
    fs::copy(shipped, desk.path("slant-well.toml")).unwrap();
    fs::write(desk.path("rig.las"), slant_log(&desk)).unwrap();
    desk
}

const IMPORT: [&str; 4] = ["import", "rig.las", "-o", "well.toml"];

/// The log is made with friction factors, noise and a block weight; the program is given that
/// weight, and recovers the factors.
#[test]
fn friction_comes_back_from_a_file() {
    let desk = desk();
    let output = desk.run(&IMPORT);
    assert_eq!(output.status.code(), Some(2));
    assert_snapshot!("import_log_asks", transcript(&output));
    let arguments = [&IMPORT[..], &["--value", "block-weight=245 kN"]].concat();
    assert_snapshot!("import_log", transcript(&desk.run(&arguments)));
    assert_snapshot!("import_log_case", desk.text("well.toml"));
    assert_snapshot!("import_log_measured", desk.text("well-measured.csv"));
    assert!(desk.text("well-picks.html").contains("rig.las"));

    // The picked weights include the block, and the case gives its weight, which is subtracted.
    let calibrate = ["calibrate", "slant-well.toml", "--data", "well-measured.csv", "-o", "out"];
    let block = ["--set", "rig.block_weight=245kN"];
    let output = desk.done(&[&calibrate[..], &block].concat());
    let output = String::from_utf8(output.stdout).unwrap();
    assert!(output.contains("245"), "{output}");
    let summary = CalibrationSummary::read(&desk.path("out/summary.json")).unwrap();
    for (estimate, (name, made)) in
        summary.estimates.iter().zip([("friction_cased", 0.2), ("friction_open", 0.3)])
    {
        assert_eq!(estimate.parameter, name);
        let error = estimate.standard_error.unwrap();
        // Two normal numbers are within three errors with a probability of 99.5 %; the seed is
        // fixed.
        assert!((estimate.value - made).abs() < 3.0 * error && error < 0.03, "{estimate:?}");
    }
}

/// A log together with a survey and a string makes a case that is planned with the measurements.
#[test]
fn a_log_is_a_part_of_a_case() {
    let desk = desk();
    for what in ["survey", "tally"] {
        let name = format!("{what}.csv");
        desk.done(&["export", "slant-well.toml", "--what", what, "--to", "csv", "-o", &name]);
    }
    let files = [&["import", "survey.csv", "tally.csv"], &IMPORT[1..]].concat();
    desk.done(&[&files[..], &["--value", "block-weight=245 kN"]].concat());
    // Missing from all three files.
    let hole = "\n[[well.hole]]\nkind = \"casing\"\nto = \"650 m\"\ndiameter = \"8.835 in\"\nfriction = 0.2\n\
                [[well.hole]]\nkind = \"open\"\nto = \"1200 m\"\ndiameter = \"8.5 in\"\nfriction = 0.3\n\
                [mud]\ndensity = \"1.1 sg\"\n";
    let text = desk.text("well.toml").replace("\n[operation]\n", &format!("{hole}\n[operation]\n"));
    // The log has torques on bottom, for which the case must drill; the error names the key to add.
    fs::write(desk.path("well.toml"), &text).unwrap();
    let refused = transcript(&desk.run(&["check", "well.toml"]));
    assert!(refused.contains("add \"drill\" to `kind` in [operation]"), "{refused}");
    let drills = "\"rotate_off_bottom\", \"drill\"]\nwob = \"5 tf\"\nrop = \"20 m/h\"";
    let text = text.replace("\"rotate_off_bottom\"]", drills);
    fs::write(desk.path("well.toml"), text).unwrap();
    let case = wholestring_case::load(&desk.path("well.toml"), &[]).unwrap();
    assert_eq!(case.setup().rig.block_weight_N, Some(245e3));
    let measured = desk.done(&["plan", "well.toml", "-o", "plan"]);
    let stdout = String::from_utf8(measured.stdout).unwrap();
    assert!(stdout.contains("measured: "), "{stdout}");
}
