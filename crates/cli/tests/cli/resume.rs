//! `run --resume`: a run that was interrupted or killed ends with the results of an uninterrupted
//! one.

use std::{
    collections::BTreeMap,
    fs,
    process::{Child, Stdio},
    thread::sleep,
    time::{Duration, Instant, SystemTime},
};

use insta::assert_snapshot;
use serde_json::Value;
use wholestring_results::Table;

use crate::desk::{Desk, args, transcript};

/// All output of a run except its wall-clock time: every file but the summary and the page, to the
/// byte.
fn leavings(desk: &Desk, folder: &str) -> (Value, BTreeMap<String, Vec<u8>>) {
    let files = fs::read_dir(desk.path(folder)).unwrap();
    let mut files: BTreeMap<String, Vec<u8>> = files
        .map(|entry| entry.unwrap())
        .map(|entry| {
            let name = entry.file_name().into_string().unwrap();
            (name, fs::read(entry.path()).unwrap())
        })
        .collect();
    // The cases of a sweep have neither of these.
    files.remove("report.html");
    files.remove(".wholestring");
    let summary = files.remove("summary.json").unwrap();
    let mut summary: Value = serde_json::from_slice(&summary).unwrap();
    for operation in summary["operations"].as_array_mut().unwrap() {
        if let Some(numerics) = operation["numerics"].as_object_mut() {
            assert!(numerics.remove("wall_time_s").is_some());
            assert!(numerics.remove("real_time_factor").is_some());
        }
    }
    (summary, files)
}

/// All optional tables, and frames that fill more than one row group.
pub(crate) const RECORDS: [&str; 5] =
    ["--csv", "--set", "records.frames=20 Hz", "--set", "records.spectra=hook_load"];

/// Two operations with both models.
fn arguments<'a>(duration: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    [&["run", "slant.toml", "--set", duration], &RECORDS[..], more].concat()
}

fn frames(desk: &Desk, folder: &str) -> Table {
    desk.table(&format!("{folder}/frames.parquet"))
}

fn begin(desk: &Desk, arguments: &[&str]) -> Child {
    desk.command(arguments).stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap()
}

/// Waits until there is a checkpoint newer than `since`; false if the run ended before.
fn checkpointed(desk: &Desk, child: &mut Child, since: SystemTime) -> bool {
    let begin = Instant::now();
    while child.try_wait().unwrap().is_none() {
        assert!(begin.elapsed() < Duration::from_secs(120), "no checkpoint");
        let written = fs::metadata(desk.path("killed/checkpoint.bin"));
        if written.is_ok_and(|file| file.modified().unwrap() > since) {
            return true;
        }
        sleep(Duration::from_millis(1));
    }
    false
}

/// A run is killed up to `times` times, each up to 80 ms after the first checkpoint since the last,
/// and resumed each time. It must end with the same bits as an uninterrupted run.
fn killed(times: u32, duration: &str) {
    let desk = Desk::new();
    desk.done(&arguments(duration, &["-o", "whole"]));

    let mut random = 1_u64;
    let mut kills = 0;
    let often = ["--checkpoint", "0.01 s"];
    let begun = |folder: [&'static str; 2]| {
        begin(&desk, &arguments(duration, &[&folder[..], &often].concat()))
    };
    let mut since = SystemTime::UNIX_EPOCH;
    let mut child = begun(["-o", "killed"]);
    while kills < times && checkpointed(&desk, &mut child, since) {
        random =
            random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        sleep(Duration::from_micros((random >> 33) % 80_000));
        if child.try_wait().unwrap().is_some() {
            break;
        }
        child.kill().unwrap();
        child.wait().unwrap();
        kills += 1;
        let written = fs::metadata(desk.path("killed/checkpoint.bin"));
        since = written.unwrap().modified().unwrap();
        child = begun(["--resume", "killed"]);
    }
    let output = child.wait_with_output().unwrap();
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "after {kills} kills: {message}");
    assert!(kills >= times / 2, "killed {kills} times only");
    assert!(frames(&desk, "whole").rows() > 131_072, "one row group");
    assert_same(&desk, "killed", "whole");
}

/// Asserts that two folders have the same files: their numbers would fill pages.
pub(crate) fn assert_same(desk: &Desk, one: &str, other: &str) {
    let [(one, files), (other, expected)] = [one, other].map(|folder| leavings(desk, folder));
    let names = files.keys().collect::<Vec<_>>();
    assert_eq!(names, expected.keys().collect::<Vec<_>>());
    for name in names {
        assert!(files[name] == expected[name], "{name} differs");
    }
    assert!(one == other, "summary.json differs");
}

#[test]
fn a_killed_run_ends_as_if_nothing_had_happened() {
    killed(4, "dynamics.duration=80 s");
}

#[test]
#[ignore = "minutes: run by cargo xtask verify"]
fn a_run_killed_at_twenty_moments_ends_as_if_nothing_had_happened() {
    killed(20, "dynamics.duration=200 s");
}

/// Ctrl-C writes a checkpoint however long the interval is, and prints how to continue.
#[cfg(unix)]
#[test]
fn ctrl_c_lays_a_run_aside() {
    use wholestring_results::Data;

    let desk = Desk::new();
    let with = |more: [&'static str; 2]| arguments("dynamics.duration=100 s", &more);
    desk.done(&with(["-o", "whole"]));
    // The soft string's results are written before the dynamics begin.
    let begun = || desk.path("stopped/summary.json").exists();
    let stopped = with(["-o", "stopped"]);
    assert_eq!(
        desk.interrupted(&stopped, begun, Duration::from_millis(50)),
        "interrupted: partial results are in stopped\n\
         to continue, run the case with --resume stopped\n"
    );
    let partial = frames(&desk, "stopped");
    let whole = frames(&desk, "whole");
    assert!(partial.rows() < whole.rows());
    for (partial, whole) in partial.columns().iter().zip(whole.columns()) {
        let same = match (&partial.data, &whole.data) {
            (Data::Number(partial), Data::Number(whole)) => whole.starts_with(partial),
            (Data::Text(partial), Data::Text(whole)) => whole.starts_with(partial),
            _ => false,
        };
        assert!(same, "{}", whole.name);
    }
    desk.done(&with(["--resume", "stopped"]));
    assert_same(&desk, "stopped", "whole");
    let mut child = begin(&desk, &["run", "slant.toml", "--resume", "stopped"]);
    assert_eq!(child.wait().unwrap().code(), Some(2));
}

/// A run of 65 000 samples, written 16 384 at a time.
fn long_run(more: &[&'static str]) -> Vec<&'static str> {
    let run = args(
        "run slant.toml --csv --set model=dynamic --set operation.kind=rotate_off_bottom \
         --set 'mesh.element_length=30 m' --set 'dynamics.sample_interval=0.001 s' \
         --set 'dynamics.settle=5 s' --set 'dynamics.duration=60 s' --set records.spectra=hook_load",
    );
    [&run[..], more].concat()
}

/// Whether a part of the series and a checkpoint that refers to it are on disk.
fn is_long(desk: &Desk, folder: &str) -> bool {
    let there = |name: &str| fs::metadata(desk.path(&format!("{folder}/{name}"))).ok();
    let written = |name: &str| there(name).map(|file| file.modified().unwrap());
    let part = written("time.parts/000002.parquet");
    part.is_some() && written("checkpoint.bin") > part
}

/// A series that is written while it grows is the same to the byte wherever the run was killed, and
/// its report covers all of it.
#[test]
fn a_long_series_is_continued_without_loss() {
    use wholestring::dynamics::Statistic;

    let desk = Desk::new();
    desk.done(&long_run(&["-o", "whole"]));
    assert!(!desk.path("whole/time.parts").exists());
    let time = desk.table("whole/time.parquet");
    let column = |name: &str| -> Vec<f64> {
        time.numbers(name).unwrap().iter().map(|value| value.unwrap()).collect()
    };
    let times_s = column("time_s");
    assert_eq!(times_s.len(), 65_000);
    assert!(times_s.windows(2).all(|pair| (pair[1] - pair[0] - 1e-3).abs() < 1e-9));
    let summary = desk.summary("whole");
    let solved = &summary.operations[0];
    let settle_s = solved.numerics.as_ref().unwrap().run.settle_s;
    let from = times_s.partition_point(|time_s| *time_s < settle_s);
    for (name, found) in solved.statistics.as_ref().unwrap() {
        let expected = Statistic::of(&column(name)[from..]).unwrap();
        let numbers =
            |it: &Statistic| [it.mean, it.std, it.min, it.max, it.p05, it.p95, it.std_error];
        assert_eq!(numbers(found), numbers(&expected), "{name}");
    }

    let often = ["-o", "killed", "--checkpoint", "0.01 s"];
    desk.killed(&long_run(&often), || is_long(&desk, "killed"));
    desk.done(&long_run(&["--resume", "killed"]));
    assert_same(&desk, "killed", "whole");
}

/// Ctrl-C keeps the series so far, and a resumed run adds the rest.
#[cfg(unix)]
#[test]
fn an_interrupted_long_series_is_kept() {
    let desk = Desk::new();
    desk.done(&long_run(&["-o", "whole"]));
    let whole = desk.table("whole/time.parquet");
    let often = ["-o", "stopped", "--checkpoint", "0.01 s"];
    desk.interrupted(&long_run(&often), || is_long(&desk, "stopped"), Duration::ZERO);
    let partial = desk.table("stopped/time.parquet");
    let loads = partial.numbers("hook_load_N").unwrap();
    assert!((32_768..65_000).contains(&loads.len()), "{}", loads.len());
    assert!(whole.numbers("hook_load_N").unwrap().starts_with(loads));
    desk.done(&long_run(&["--resume", "stopped"]));
    assert_same(&desk, "stopped", "whole");
}

/// A run resumed with another case would match neither.
#[test]
fn what_cannot_be_resumed_is_refused() {
    let desk = Desk::new();
    let resume = |more: &[&str]| {
        let output = desk.run(&[&["run", "slant.toml", "--resume", "results"], more].concat());
        assert_eq!(output.status.code(), Some(2));
        transcript(&output)
    };
    assert_snapshot!("resume_without_folder", resume(&[]));
    fs::create_dir(desk.path("results")).unwrap();
    assert_snapshot!("resume_without_checkpoint", resume(&[]));

    let soft = ["--set", "model=soft"];
    desk.done(&[&["run", "slant.toml", "-o", "results"], &soft[..]].concat());
    assert_snapshot!("resume_a_finished_run", resume(&soft));

    let often = args("run slant.toml -o killed --checkpoint '0.01 s'");
    desk.killed(&often, || desk.path("killed/checkpoint.bin").exists());
    let checkpoint = fs::read(desk.path("killed/checkpoint.bin")).unwrap();
    let put = |bytes: &[u8]| fs::write(desk.path("results/checkpoint.bin"), bytes).unwrap();
    put(&checkpoint);
    let other = ["--set", "well.hole.1.friction=0.3"];
    assert_snapshot!("resume_another_case", resume(&other));
    let mut damaged = checkpoint.clone();
    damaged[checkpoint.len() / 2] ^= 4;
    put(&damaged);
    assert_snapshot!("resume_from_a_damaged_file", resume(&[]));
    put(&checkpoint[..checkpoint.len() / 2]);
    assert!(resume(&[]).contains("it is damaged"));
    put(b"");
    assert!(resume(&[]).contains("it does not begin like one"));
    assert_snapshot!("resume_into_another_folder", resume(&["-o", "elsewhere"]));

    // A fresh run neither uses the remains nor removes them without `--overwrite`.
    put(&checkpoint);
    let anew = [&["run", "slant.toml", "-o", "results"], &soft[..]].concat();
    assert_eq!(desk.run(&anew).status.code(), Some(2));
    assert_eq!(fs::read(desk.path("results/checkpoint.bin")).unwrap(), checkpoint);
    desk.done(&[&anew[..], &["--overwrite"]].concat());
    assert!(!desk.path("results/checkpoint.bin").exists());
}

#[test]
fn an_interval_that_is_none_is_refused() {
    let desk = Desk::new();
    for interval in ["0 s", "soon", "3 m", "2 d"] {
        let output = desk.run(&["run", "slant.toml", "--checkpoint", interval]);
        assert_eq!(output.status.code(), Some(2), "{interval}");
    }
}
