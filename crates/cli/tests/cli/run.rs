//! `run`: the table, the files, and what becomes of a run that does not end well.

use std::{collections::BTreeSet, f64::consts::PI, fs};

use crate::desk::{Desk, masked, transcript};
use insta::assert_snapshot;
use wholestring::outcome::ModelKind;
use wholestring_results::{Data, Status, Table};

const SOFT: [&str; 2] = ["--set", "model=soft"];

fn files(desk: &Desk, folder: &str) -> BTreeSet<String> {
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
    let expected = [
        "contact.parquet",
        "nodes.parquet",
        "profile.svg",
        "report.html",
        "summary.json",
        "time.parquet",
        "wear.parquet",
    ];
    assert_eq!(
        files(&desk, "out/Straight slant"),
        expected.map(String::from).into()
    );
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
    assert!(
        desk.run(&[&["run", "slant.toml"], &SOFT[..]].concat())
            .status
            .success()
    );
    let summary = desk.summary("out/Straight slant");
    let weight_N =
        (7850.0 - 1200.0) * 9.80665 * PI / 4.0 * (0.12_f64.powi(2) - 0.08_f64.powi(2)) * 600.0;
    let (along_N, across_N) = (0.5 * weight_N, 0.75_f64.sqrt() * weight_N);
    let [trip_out, rotate] = &summary.operations[..] else {
        panic!("two operations");
    };
    // The equations are linear in depth here: what is left is rounding of some 600 steps.
    let close = |obtained: f64, expected: f64| {
        assert!(
            (obtained / expected - 1.0).abs() < 1e-12,
            "{obtained} against {expected}"
        );
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
    assert_eq!(
        files(&desk, "here/and/there"),
        expected.map(String::from).into()
    );

    let summary = desk.summary("here/and/there");
    let solved: Vec<_> = summary
        .operations
        .iter()
        .map(|solved| (solved.model, solved.operation.as_str(), &solved.status))
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

    check_climb(&Table::read_parquet(&desk.path("here/and/there/nodes.parquet")).unwrap());

    let time = Table::read_parquet(&desk.path("here/and/there/time.parquet")).unwrap();
    // Two operations of 2 s, a row every 10 ms: the sampling interval is a whole number of steps, so
    // that it is 10 ms within half a step.
    assert!((380..=420).contains(&time.rows()), "{} rows", time.rows());
    let Data::Number(times) = &time.column("time_s").unwrap().data else {
        panic!("times are numbers");
    };
    assert!((times[time.rows() - 1].unwrap() - 2.0).abs() < 0.02);
}

/// A string that turns clockwise climbs to the right, to `atan 0.25`; one that is pulled stays on the low
/// side; the soft string has no place to climb to.
fn check_climb(nodes: &Table) {
    let text = |name: &str| match &nodes.column(name).unwrap().data {
        Data::Text(words) => words,
        Data::Number(_) => panic!("`{name}` is text"),
    };
    let (models, operations) = (text("model"), text("operation"));
    let Data::Number(climb) = &nodes.column("climb_rad").unwrap().data else {
        panic!("angles are numbers");
    };
    let of = |model: &str, operation: &str| -> Vec<f64> {
        (0..nodes.rows())
            .filter(|row| models[*row] == model && operations[*row] == operation)
            .filter_map(|row| climb[row])
            .collect()
    };
    for operation in ["trip_out", "rotate_off_bottom"] {
        assert!(of("soft", operation).is_empty(), "{operation}");
    }
    let median = |operation: &str| {
        let mut values = of("dynamic", operation);
        values.sort_by(f64::total_cmp);
        values[values.len() / 2]
    };
    // After 2 s what is left of the start still moves it by some hundredths.
    let (pulled, turned) = (median("trip_out"), median("rotate_off_bottom"));
    assert!(pulled.abs() < 0.05, "{pulled}");
    assert!((turned - 0.25_f64.atan()).abs() < 0.05, "{turned}");
}

/// Tripping out takes `w L (cos i + μ sin i)` and rotating `μ r w L sin i`, as in
/// `the_numbers_are_the_closed_forms`. The limits lie 1 % to either side.
#[test]
fn what_the_rig_cannot_do_is_told() {
    let desk = Desk::new();
    let weight_N =
        (7850.0 - 1200.0) * 9.80665 * PI / 4.0 * (0.12_f64.powi(2) - 0.08_f64.powi(2)) * 600.0;
    let hook_N = weight_N * (0.5 + 0.25 * 0.75_f64.sqrt());
    let torque_N_m = 0.25 * 0.06 * weight_N * 0.75_f64.sqrt();
    let block_N = 50e3;
    let warnings = |part: f64, more: &[&str]| -> Vec<String> {
        let rig = [
            format!("rig.block_weight={block_N} N"),
            format!("rig.hoist_capacity={} N", part * (hook_N + block_N)),
            format!("rig.top_drive_torque={} N.m", part * torque_N_m),
        ];
        let mut arguments = vec!["run", "slant.toml"];
        arguments.extend(rig.iter().flat_map(|limit| ["--set", limit]));
        arguments.extend(more);
        let output = desk.run(&arguments);
        assert!(output.status.success());
        let text = String::from_utf8(output.stdout).unwrap();
        let warnings = text.lines().filter(|line| line.starts_with("warning: "));
        warnings.map(str::to_owned).collect()
    };
    assert!(warnings(1.01, &SOFT).is_empty());
    let kilo = |value: f64| format!("{:.2} kN", value / 1e3);
    let beyond = warnings(0.99, &SOFT);
    assert_eq!(beyond.len(), 2, "{beyond:?}");
    assert!(
        beyond[0].starts_with(&format!(
            "warning: trip out (soft): hook load with block of {}",
            kilo(hook_N + block_N)
        )),
        "{beyond:?}"
    );
    assert!(
        beyond[0].contains(&kilo(0.99 * (hook_N + block_N))),
        "{beyond:?}"
    );
    assert!(
        beyond[1].starts_with("warning: rotate off bottom (soft): surface torque of "),
        "{beyond:?}"
    );
    // Of the dynamics, whose friction torque is 3 % lower, the largest sample counts: a string that is
    // still finding its place swings by more.
    let dynamic = warnings(0.9, &["--set", "model=dynamic"]);
    let of = |what: &str| dynamic.iter().any(|line| line.contains(what));
    assert!(
        of("trip out (dynamic): hook load with block"),
        "{dynamic:?}"
    );
    assert!(
        of("rotate off bottom (dynamic): surface torque"),
        "{dynamic:?}"
    );
}

#[test]
fn quiet_prints_nothing() {
    let desk = Desk::new();
    let output = desk.run(&[&["run", "slant.toml", "--quiet"], &SOFT[..]].concat());
    assert!(output.status.success());
    assert!(output.stdout.is_empty() && output.stderr.is_empty());
}

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
    assert_snapshot!(transcript(&desk.run(&[
        "run",
        "slant.toml",
        "-o",
        "slant.toml"
    ])));
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

/// A lift of ten thousand tonnes throws the string out of the hole.
#[test]
fn diverged() {
    let desk = Desk::new();
    let output = desk.run(&[
        "run",
        "slant.toml",
        "-o",
        "results",
        "--set",
        "hoist.control=hook-load",
        "--set",
        "hoist.hook_load=1e8 N",
    ]);
    assert_eq!(output.status.code(), Some(3));
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(
        message.starts_with("error: trip_out: the run diverged"),
        "{message}"
    );
    assert!(
        message.ends_with("what was computed until then is in results\n"),
        "{message}"
    );
    let table = String::from_utf8(output.stdout).unwrap();
    assert!(
        table.contains("dynamic*") && table.contains("\n* as far as it was computed\n"),
        "{table}"
    );

    let summary = desk.summary("results");
    let [soft, dynamic] = &summary.operations[..] else {
        panic!("the run goes on to the next operation");
    };
    assert_eq!(soft.status, Status::Complete);
    assert!(matches!(&dynamic.status, Status::Failed(reason) if message.contains(reason)));
    let time = Table::read_parquet(&desk.path("results/time.parquet")).unwrap();
    assert!(time.rows() > 0);
    // No number in a file is none: JSON would say `null` where the contract has a number.
    let numerics = dynamic.numerics.as_ref().expect("a dynamic model");
    assert_eq!(
        (numerics.energy_residual, numerics.energy),
        (1.0, None),
        "a run that diverged balances nothing"
    );
    assert!(numerics.max_penetration_m.is_finite());
    let nodes = Table::read_parquet(&desk.path("results/nodes.parquet")).unwrap();
    let last = |table: &Table, name: &str| match table.column(name).map(|column| &column.data) {
        Some(Data::Number(values)) => values.last().copied().flatten(),
        _ => None,
    };
    for name in ["time_s", "hook_load_N", "surface_torque_N_m", "stretch_m"] {
        assert!(last(&time, name).is_some(), "{name}");
    }
    // The last row is the bit's, by the dynamic model.
    for name in ["md_m", "tension_N", "torque_N_m", "contact_force_N"] {
        assert!(last(&nodes, name).is_some(), "{name}");
    }
}

/// Ctrl-C keeps what was computed, and says so. Other systems than Unix have no way to send it to
/// another process from a test.
#[cfg(unix)]
#[test]
fn interrupted() {
    use std::{
        process::{Command, Stdio},
        thread::sleep,
        time::{Duration, Instant},
    };

    let desk = Desk::new();
    let mut child = desk
        .command(&[
            "run",
            "slant.toml",
            "-o",
            "results",
            "--set",
            "dynamics.duration=3600 s",
        ])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // The soft string is on the disk when the dynamics begin.
    let begin = Instant::now();
    while !desk.path("results/summary.json").exists() {
        assert!(
            begin.elapsed() < Duration::from_secs(60),
            "the run does not begin"
        );
        sleep(Duration::from_millis(20));
    }
    sleep(Duration::from_millis(500));
    let sent = Command::new("kill")
        .args(["-INT", &child.id().to_string()])
        .status();
    assert!(sent.unwrap().success());
    let status = child.wait().unwrap();
    assert_eq!(status.code(), Some(130));
    let mut message = String::new();
    std::io::Read::read_to_string(&mut child.stderr.take().unwrap(), &mut message).unwrap();
    assert_eq!(
        message,
        "interrupted: what was computed is in results\n\
         to go on, run the case with --resume results\n"
    );

    let summary = desk.summary("results");
    let statuses: Vec<_> = summary
        .operations
        .iter()
        .map(|solved| &solved.status)
        .collect();
    assert_eq!(statuses, [&Status::Complete, &Status::Interrupted]);
    let time = Table::read_parquet(&desk.path("results/time.parquet")).unwrap();
    assert!(time.rows() > 0);
}

/// A run that is stopped before its window begins has a profile of what it sampled until then.
#[test]
fn a_profile_without_window() {
    let desk = Desk::new();
    let output = desk.run(&[
        "run",
        "slant.toml",
        "-o",
        "results",
        "--set",
        "model=dynamic",
        "--set",
        "dynamics.settle=100 s",
        "--set",
        "hoist.control=hook-load",
        "--set",
        "hoist.hook_load=1e8 N",
        "--set",
        "dynamics.sample_interval=1 ms",
    ]);
    assert_eq!(output.status.code(), Some(3));
    let nodes = Table::read_parquet(&desk.path("results/nodes.parquet")).unwrap();
    let Data::Number(tensions) = &nodes.column("tension_N").unwrap().data else {
        panic!("tensions are numbers");
    };
    // Ten thousand tonnes at the top.
    assert!(tensions[0].unwrap() > 1e6, "{:?}", tensions[0]);
}

fn numbers(table: &Table, name: &str) -> Vec<f64> {
    match &table
        .column(name)
        .unwrap_or_else(|| panic!("no `{name}`"))
        .data
    {
        Data::Number(values) => values.iter().copied().flatten().collect(),
        Data::Text(_) => panic!("`{name}` holds words"),
    }
}

/// Frames ten times a second of the two seconds of each operation, and a spectrum of the window: the frames
/// agree with the table of time, the spectrum with the statistics. A later run without them leaves none.
#[test]
fn frames_and_spectra() {
    let desk = Desk::new();
    let records = [
        "--set",
        "records.frames=10 Hz",
        "--set",
        "records.channels=[\"rotation\", \"force\"]",
        "--set",
        "records.spectra=hook_load",
        "--set",
        "records.node_spectra=[\"rotary_speed\", \"tension\"]",
        "--set",
        "records.node_spectra_at=[\"0 m\", \"150 m\"]",
        "--set",
        "records.spectrum_segment=1 s",
        "--set",
        "model=dynamic",
    ];
    let output = desk.run(&[&["run", "slant.toml", "-o", "out"], &records[..]].concat());
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{message}");

    let frames = Table::read_parquet(&desk.path("out/frames.parquet")).unwrap();
    let nodes = Table::read_parquet(&desk.path("out/nodes.parquet"))
        .unwrap()
        .rows()
        / 2;
    let time = Table::read_parquet(&desk.path("out/time.parquet")).unwrap();
    // A sample is a whole number of steps, 0.6 ms each, and a frame ten samples.
    let taken = time.rows() / 2 / 10;
    assert!((19..=20).contains(&taken), "{taken}");
    assert_eq!(frames.rows(), 2 * taken * nodes);
    let names: Vec<&str> = frames.columns().iter().map(|c| c.name.as_str()).collect();
    let expected = [
        "operation",
        "time_s",
        "node",
        "md_m",
        "rotary_speed_rad_per_s",
        "twist_rad",
        "tension_N",
        "torque_N_m",
    ];
    assert_eq!(names, expected);
    let (times, twists) = (numbers(&time, "time_s"), numbers(&time, "twist_rad"));
    let (frame_times, frame_twists) = (numbers(&frames, "time_s"), numbers(&frames, "twist_rad"));
    // The last operation, whose rows come last, turns the string.
    let last = frames.rows() - nodes;
    let row = times.iter().rposition(|t| *t == frame_times[last]).unwrap();
    assert!(twists[row] != 0.0);
    assert!(
        (frame_twists[last] / twists[row] - 1.0).abs() < 1e-6,
        "single precision"
    );

    // One segment over the whole window: Hann's window weighs its middle, the variance comes out roughly.
    let spectra = Table::read_parquet(&desk.path("out/spectra.parquet")).unwrap();
    let frequencies = numbers(&spectra, "frequency_Hz");
    assert!((frequencies[1] - 1.0).abs() < 0.03, "{}", frequencies[1]);
    // Of either operation a scalar and two signals of two nodes.
    let rows = spectra.rows() / 10;
    let density = numbers(&spectra, "density");
    let variance: f64 = density[..rows].iter().sum::<f64>() * frequencies[1];
    let md_m = numbers(&spectra, "md_m");
    assert_eq!(md_m.len(), 8 * rows, "a scalar has no depth");
    for (spectrum, depth_m) in [0.0, 0.0, 150.0, 150.0].into_iter().enumerate() {
        let found = md_m[spectrum * rows];
        assert!((found - depth_m).abs() < 2.5, "{found} for {depth_m} m");
    }
    let summary = desk.summary("out");
    let std = summary.operations[0].statistics.as_ref().unwrap()["hook_load_N"].std;
    assert!(
        (0.2..5.0).contains(&(variance.sqrt() / std)),
        "{variance} for {std}²"
    );

    let output = desk.run(&[&["run", "slant.toml", "-o", "out"], &SOFT[..]].concat());
    assert!(output.status.success());
    let expected = [
        "contact.parquet",
        "nodes.parquet",
        "profile.svg",
        "report.html",
        "summary.json",
        "time.parquet",
        "wear.parquet",
    ];
    assert_eq!(files(&desk, "out"), expected.map(String::from).into());
}

/// A tuned lift is told of on the screen and in the summary, and is what the answer was computed with.
#[test]
fn a_tuned_lift_is_reported() {
    let desk = Desk::new();
    let arguments = [
        "run",
        "slant.toml",
        "--set",
        "model=dynamic",
        "--set",
        "operation.kind=drill",
        "--set",
        "hoist.control=tuned-lift",
    ];
    let output = desk.run(&arguments);
    assert!(output.status.success());
    let text = String::from_utf8(output.stdout).unwrap();
    let summary = desk.summary("out/Straight slant");
    let solved = &summary.operations[0];
    let lift = solved.lift.expect("a lift");
    assert!((lift.weight_on_bit_N / 20e3 - 1.0).abs() <= 0.01);
    assert_eq!(lift.weight_on_bit_N, solved.scalars.weight_on_bit_N);
    assert!((lift.hook_load_N / solved.scalars.hook_load_N - 1.0).abs() < 1e-9);
    let told = format!("found in {} runs", lift.runs);
    assert!(text.contains("Lift: ") && text.contains(&told), "{text}");

    // Frames are those of the run with that lift.
    let frames = [
        &arguments[..],
        &["--set", "records.frames=20 Hz", "-o", "frames"],
    ]
    .concat();
    assert!(desk.run(&frames).status.success());
    let again = desk.summary("frames");
    assert_eq!(again.operations[0].scalars, solved.scalars);
    assert_eq!(again.operations[0].lift, solved.lift);
    assert!(desk.path("frames").join("frames.parquet").exists());
}

/// A weight that no lift gives ends the run with the nearest one.
#[test]
fn a_lift_that_is_not_found_says_which_came_nearest() {
    let desk = Desk::new();
    let output = desk.run(&[
        "run",
        "slant.toml",
        "--set",
        "model=dynamic",
        "--set",
        "operation.kind=drill",
        "--set",
        "hoist.control=tuned-lift",
        "--set",
        "wob=240 kN",
        "--set",
        "mud.density=1.0 sg",
    ]);
    assert_eq!(output.status.code(), Some(3));
    let told = String::from_utf8(output.stderr).unwrap();
    assert!(
        told.contains("no constant lift gives a mean weight on bit of 240.0 kN"),
        "{told}"
    );
}

/// A bit whose weight swings beyond its table is told of on the screen and in the summary; its rate of penetration is
/// among the statistics.
#[test]
fn a_table_that_the_bit_leaves_is_told_of() {
    let desk = Desk::new();
    let table = "weight_on_bit_N,rotary_speed_rpm,rate_of_penetration_m_per_h,torque_N_m,weight_on_bit_std_N\n\
                 5e3,30,2,200,3e3\n5e3,120,8,200,3e3\n20e3,30,8,800,3e3\n20e3,120,32,800,3e3\n";
    fs::write(desk.path("bit.csv"), table).unwrap();
    let output = desk.run(&[
        "run",
        "slant.toml",
        "--set",
        "model=dynamic",
        "--set",
        "operation.kind=drill",
        "--set",
        "bit.law=table",
        "--set",
        "bit.table.file=bit.csv",
    ]);
    assert!(output.status.success());
    let summary = desk.summary("out/Straight slant");
    let solved = &summary.operations[0];
    let of = solved.bit_table.expect("a table");
    assert!(of.outside_fraction > 0.1 && of.outside_fraction < 0.9);
    assert!(of.weights_N[1] > 20e3);
    let text = String::from_utf8(output.stdout).unwrap();
    let told = format!(
        "the bit was outside its table for {:.1} % of the time",
        of.outside_fraction * 100.0
    );
    assert!(text.contains(&told), "{text}");
    let rate = solved.statistics.as_ref().unwrap()["rate_of_penetration_m_per_s"];
    assert!((rate.mean * 3600.0 / 16.0 - 1.0).abs() < 0.2, "{rate:?}");
}
