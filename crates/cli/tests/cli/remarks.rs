//! Remarks of a run: exceeded limits of the rig, a tuned lift, a bit outside its table.

use std::{f64::consts::PI, fs};

use crate::{
    desk::{Desk, args},
    run::SOFT,
};

/// Tripping out takes `w L (cos i + μ sin i)` and rotating `μ r w L sin i`, as in
/// `the_numbers_are_the_closed_forms`. The limits are 1 % to either side.
#[test]
fn what_the_rig_cannot_do_is_told() {
    let desk = Desk::new();
    let weight_N =
        (7850.0 - 1200.0) * 9.80665 * PI / 4.0 * (0.12_f64.powi(2) - 0.08_f64.powi(2)) * 600.0;
    let hook_N = weight_N * (0.5 + 0.25 * 0.75_f64.sqrt());
    let torque_N_m = 0.25 * 0.06 * weight_N * 0.75_f64.sqrt();
    let block_N = 50e3;
    let errors = |part: f64, more: &[&str]| -> Vec<String> {
        let rig = [
            format!("rig.block_weight={block_N} N"),
            format!("rig.hoist_capacity={} N", part * (hook_N + block_N)),
            format!("rig.top_drive_torque={} N.m", part * torque_N_m),
        ];
        let mut arguments = vec!["run", "slant.toml"];
        arguments.extend(rig.iter().flat_map(|limit| ["--set", limit]));
        arguments.extend(more);
        let output = desk.done(&arguments);
        let text = String::from_utf8(output.stdout).unwrap();
        let errors = text.lines().filter(|line| line.starts_with("error: "));
        errors.map(str::to_owned).collect()
    };
    assert!(errors(1.01, &SOFT).is_empty());
    let kilo = |value: f64| format!("{:.1} kN", value / 1e3);
    let beyond = errors(0.99, &SOFT);
    assert_eq!(beyond.len(), 2, "{beyond:?}");
    assert!(
        beyond[0].starts_with(&format!(
            "error: trip out (soft): Hoist: load {} (hook load {} and block {})",
            kilo(hook_N + block_N),
            kilo(hook_N),
            kilo(block_N).replace(".0", ""),
        )),
        "{beyond:?}"
    );
    assert!(beyond[0].contains(&kilo(0.99 * (hook_N + block_N))), "{beyond:?}");
    let torque = "error: rotate off bottom (soft): Top drive, continuous: load ";
    assert!(beyond[1].starts_with(torque), "{beyond:?}");
    // Of the dynamics, whose friction torque is 3 % lower, the largest sample counts, because a
    // string that is still settling swings by more.
    let dynamic = errors(0.9, &["--set", "model=dynamic"]);
    let any = |what: &str| dynamic.iter().any(|line| line.contains(what));
    assert!(any("trip out (dynamic): Hoist: load"), "{dynamic:?}");
    assert!(any("rotate off bottom (dynamic): Top drive, "), "{dynamic:?}");
}

/// A tuned lift is reported on the screen and in the summary, and is the lift of the computed
/// results.
#[test]
fn a_tuned_lift_is_reported() {
    let desk = Desk::new();
    let arguments = args(
        "run slant.toml --set model=dynamic --set operation.kind=drill \
         --set hoist.control=tuned-lift",
    );
    let output = desk.done(&arguments);
    let text = String::from_utf8(output.stdout).unwrap();
    let summary = desk.summary("out/Straight slant");
    let solved = &summary.operations[0];
    let lift = solved.lift.expect("a lift");
    assert!((lift.weight_on_bit_N / 20e3 - 1.0).abs() <= 0.01);
    assert_eq!(lift.weight_on_bit_N, solved.scalars.weight_on_bit_N);
    assert!((lift.hook_load_N / solved.scalars.hook_load_N - 1.0).abs() < 1e-9);
    let sentence = format!("found in {} runs", lift.runs);
    assert!(text.contains("Lift: ") && text.contains(&sentence), "{text}");

    // Frames are those of the run with that lift.
    let frames = [&arguments[..], &["--set", "records.frames=20 Hz", "-o", "frames"]].concat();
    desk.done(&frames);
    let again = desk.summary("frames");
    assert_eq!(again.operations[0].scalars, solved.scalars);
    assert_eq!(again.operations[0].lift, solved.lift);
    assert!(desk.path("frames").join("frames.parquet").exists());
}

/// A weight that no lift gives ends the run with the nearest one.
#[test]
fn a_lift_that_is_not_found_says_which_came_nearest() {
    let desk = Desk::new();
    let output = desk.run(&args(
        "run slant.toml --set model=dynamic --set operation.kind=drill \
         --set hoist.control=tuned-lift --set 'wob=240 kN' --set 'mud.density=1.0 sg'",
    ));
    assert_eq!(output.status.code(), Some(3));
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert!(stderr.contains("no constant lift gives a mean weight on bit of 240.0 kN"), "{stderr}");
}

/// A bit whose weight swings beyond its table is reported on the screen and in the summary; its
/// rate of penetration is among the statistics.
#[test]
fn a_table_that_the_bit_leaves_is_told_of() {
    let desk = Desk::new();
    let table = "weight_on_bit_N,rotary_speed_rpm,rate_of_penetration_m_per_h,torque_N_m,weight_on_bit_std_N\n\
                 5e3,30,2,200,3e3\n5e3,120,8,200,3e3\n20e3,30,8,800,3e3\n20e3,120,32,800,3e3\n";
    fs::write(desk.path("bit.csv"), table).unwrap();
    let output = desk.done(&args(
        "run slant.toml --set model=dynamic --set operation.kind=drill \
         --set bit.law=table --set bit.table.file=bit.csv",
    ));
    let summary = desk.summary("out/Straight slant");
    let solved = &summary.operations[0];
    let bit_table = solved.bit_table.expect("a table");
    assert!(bit_table.outside_fraction > 0.1 && bit_table.outside_fraction < 0.9);
    assert!(bit_table.weights_N[1] > 20e3);
    let text = String::from_utf8(output.stdout).unwrap();
    let sentence = format!(
        "The bit was outside its table for {:.1} % of the time",
        bit_table.outside_fraction * 100.0
    );
    assert!(text.contains(&sentence), "{text}");
    let rate = solved.statistics.as_ref().unwrap()["rate_of_penetration_m_per_s"];
    assert!((rate.mean * 3600.0 / 16.0 - 1.0).abs() < 0.2, "{rate:?}");
}
