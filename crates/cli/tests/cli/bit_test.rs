//! `bit-test`: the bit alone on its rock.

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::Path,
};

use insta::assert_snapshot;
use wholestring_results::{BitTestOutcome, BitTestSummary, CheckKind, Severity, Status, Table};

use crate::desk::{Desk, args, masked, transcript};

/// Weak rock in coarse elements under a bit of 120 mm: a point takes a quarter of a second.
const ROCK: &str = r#"
[bit.face]
cutter_diameter = "19 mm"

[rock]
strength = "10 MPa"
element_size = "15 mm"
density_factor = 60

[bit_test]
wob = ["10 kN", "20 kN"]
rpm = [240, 300]
settle_revolutions = 0.25
revolutions = 1
"#;

const POINTS: [&str; 4] =
    ["wob=10kN,rpm=240", "wob=10kN,rpm=300", "wob=20kN,rpm=240", "wob=20kN,rpm=300"];

/// A desk with the rock under the slant well's bit in `rock.toml`.
pub(crate) fn desk() -> Desk {
    let desk = Desk::new();
    let slant = desk.text("slant.toml");
    fs::write(desk.path("rock.toml"), slant + ROCK).unwrap();
    desk
}

fn bit_test<'a>(more: &[&'a str]) -> Vec<&'a str> {
    [&["bit-test", "rock.toml"], more].concat()
}

fn summary(desk: &Desk, folder: &str) -> BitTestSummary {
    BitTestSummary::read(&desk.path(folder).join("summary.json")).unwrap()
}

/// Every file of a folder and the folders in it.
fn leavings(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut files = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        if path.is_dir() {
            let within = leavings(&path).into_iter();
            files.extend(within.map(|(file, bytes)| (format!("{name}/{file}"), bytes)));
        } else {
            files.insert(name, fs::read(path).unwrap());
        }
    }
    files
}

/// Tables, summary and points agree, and a case with the law "table" drills as the bit did.
#[test]
fn every_weight_at_every_speed() {
    let desk = desk();
    // The error is the difference between the revolutions.
    let two = ["-o", "results", "--csv", "--set", "bit_test.revolutions=2"];
    let output = desk.run(&bit_test(&two));
    assert_snapshot!(masked(&transcript(&output)));
    let summary = summary(&desk, "results");
    assert_eq!(summary.case, "Straight slant");
    assert_eq!(summary.bit_radius_m, 0.06);
    assert!((summary.rock_strength_Pa / 10e6 - 1.0).abs() < 1e-12);
    let names: Vec<&str> = summary.points.iter().map(|point| point.point.as_str()).collect();
    assert_eq!(names, POINTS);
    // The page and the picture are rebuilt from the files.
    let page = || fs::read(desk.path("results/report.html")).unwrap();
    let before = page();
    desk.done(&["report", "results"]);
    assert!(page() == before);
    assert!(desk.path("results/drill-off.svg").exists());
    desk.done(&["plot", "results", "-o", "pictures"]);
    let pictures: BTreeSet<String> = leavings(&desk.path("pictures")).into_keys().collect();
    let named = ["bottom-hole.svg", "drill-off.svg", "specific-energy.svg"];
    assert_eq!(pictures, named.map(String::from).into());
    let table = Table::read_csv(&desk.path("results/bit-test.csv")).unwrap();
    let law = Table::read_csv(&desk.path("results/bit-table.csv")).unwrap();
    assert_eq!((table.rows(), law.rows()), (4, 4));
    let word = |table: &Table, name: &str, row: usize| table.words(name).expect(name)[row].clone();
    let number = |table: &Table, name: &str, row: usize| -> f64 {
        word(table, name, row).parse().expect(name)
    };
    let overrides = [
        "bit.law=table",
        "bit.table.file=results/bit-table.csv",
        "operation.kind=drill",
        "wob=15 kN",
        "rpm=270",
    ];
    let overrides = overrides.map(|text| text.parse().expect("an override"));
    let lawful = wholestring_case::load(&desk.path("slant.toml"), &overrides);
    let lawful = lawful.unwrap_or_else(|report| panic!("{}", report.render(false)));
    for (row, point) in summary.points.iter().enumerate() {
        assert_eq!(point.status, Status::Complete);
        let outcome = point.outcome.expect("a finished point has one");
        let folder = desk.path("results").join(&point.point);
        let alone = BitTestOutcome::read(&folder.join("point.json")).unwrap();
        assert_eq!(alone.outcome, outcome);
        assert!(!folder.join("checkpoint.bin").exists());
        assert!(outcome.bricks_broken > 0);
        assert_eq!(outcome.revolutions.round(), 2.0);
        assert_eq!(word(&table, "point", row), point.point);
        assert_eq!(word(&table, "status", row), "complete");
        for (name, value) in [
            ("weight_on_bit_N", outcome.weight_on_bit_N),
            ("rotary_speed_rad_per_s", outcome.rotary_speed_rad_per_s),
            ("rate_of_penetration_m_per_s", outcome.rate_of_penetration_m_per_s),
            ("torque_N_m", outcome.torque_N_m),
            ("torque_error_N_m", outcome.torque_error_N_m.unwrap()),
            ("specific_energy_Pa", outcome.specific_energy_Pa.unwrap()),
            ("bricks_broken", outcome.bricks_broken as f64),
        ] {
            assert_eq!(number(&table, name, row), value, "{name}");
        }
        for (name, value) in [
            ("weight_on_bit_N", outcome.weight_on_bit_N),
            (
                "rotary_speed_rpm",
                (outcome.rotary_speed_rad_per_s * 30.0 / std::f64::consts::PI).round(),
            ),
            ("torque_N_m", outcome.torque_N_m),
            ("torque_std_N_m", outcome.torque_std_N_m),
            ("weight_on_bit_std_N", outcome.weight_on_bit_std_N),
        ] {
            assert_eq!(number(&law, name, row), value, "{name}");
        }
        let drilled =
            lawful.dynamics.bit.law.steady(outcome.weight_on_bit_N, outcome.rotary_speed_rad_per_s);
        let drilled = drilled.expect("a table knows its points");
        for (of_law, of_rock) in [
            (drilled.rate_of_penetration_m_per_s, outcome.rate_of_penetration_m_per_s),
            (drilled.torque_N_m, outcome.torque_N_m),
        ] {
            assert!((of_law / of_rock - 1.0).abs() < 1e-9, "{of_law} {of_rock}");
        }
        let bottom = Table::read_parquet(&folder.join("bottom_hole.parquet")).unwrap();
        assert!(bottom.rows() > 100, "{} cells", bottom.rows());
    }
}

/// One thread and two give the same bits.
#[test]
fn threads_leave_the_numbers_alone() {
    let desk = desk();
    for jobs in ["1", "2"] {
        let output = desk.done(&bit_test(&["-j", jobs, "-o", jobs, "--quiet"]));
        assert!(output.stdout.is_empty() && output.stderr.is_empty());
    }
    let [one, two] = ["1", "2"].map(|folder| leavings(&desk.path(folder)));
    assert!(one.contains_key("wob=10kN,rpm=240/point.json"));
    let differing: BTreeSet<_> = one.keys().filter(|name| one[*name] != two[*name]).collect();
    assert!(one.len() == two.len() && differing.is_empty(), "{differing:?}");
}

/// A resumed test keeps finished points, continues the one under way and drills the rest, with the
/// results of an uninterrupted test. An extended grid keeps its points.
#[test]
fn a_killed_test_goes_on() {
    let desk = desk();
    let first = ["-o", "killed", "-j", "1", "--checkpoint", "0.01 s"];
    let any = |name: &str| {
        let mut points = POINTS.iter();
        points.any(|point| desk.path("killed").join(point).join(name).exists())
    };
    desk.killed(&bit_test(&first), || any("point.json") && any("checkpoint.bin"));
    assert!(!desk.path("killed/bit-table.csv").exists());
    let written = |point: &str| {
        let file = desk.path("killed").join(point).join("point.json");
        fs::metadata(file).ok()?.modified().ok()
    };
    let done = POINTS.iter().find(|point| written(point).is_some()).unwrap();
    let before = written(done);
    // As if killed between the outcome and this file.
    let left = desk.path("killed").join(done).join("checkpoint.bin");
    fs::write(left, "written to a checkpoint").unwrap();
    desk.done(&bit_test(&["-o", "killed", "--resume"]));
    assert_eq!(written(done), before);
    assert!(!any("checkpoint.bin"));
    desk.done(&bit_test(&["-o", "whole"]));
    assert!(leavings(&desk.path("killed")) == leavings(&desk.path("whole")));
    // One more speed.
    let more = args("-o killed --resume --set 'bit_test.rpm=[240, 300, 360]'");
    desk.done(&bit_test(&more));
    assert_eq!(written(done), before);
    assert_eq!(summary(&desk, "killed").points.len(), 6);
}

/// Shares of the points in one folder; the table is written when all points are there.
#[test]
fn shards_make_up_the_whole() {
    let desk = desk();
    let share = |shard: &'static str| {
        let output = desk.done(&bit_test(&["-o", "shares", "--shard", shard, "--resume"]));
        String::from_utf8(output.stdout).unwrap()
    };
    assert!(share("1/2").contains("2 of 2 points finished"));
    assert!(!desk.path("shares/bit-table.csv").exists());
    share("2/2");
    assert!(desk.path("shares/bit-table.csv").exists());
    let points = summary(&desk, "shares").points;
    assert!(points.iter().all(|point| point.status == Status::Complete));
}

/// Simultaneous shares leave the files of a single test of all points.
#[test]
fn shares_at_once_make_up_the_whole() {
    let desk = desk();
    desk.done(&bit_test(&["-o", "whole", "--quiet"]));
    let begun = ["1/4", "2/4", "3/4", "4/4"].map(|shard| {
        let arguments = bit_test(&["-o", "shares", "--quiet", "--resume", "--shard", shard]);
        desk.command(&arguments).stderr(std::process::Stdio::piped()).spawn().unwrap()
    });
    for share in begun {
        let output = share.wait_with_output().unwrap();
        assert!(output.status.success(), "{}", transcript(&output));
    }
    for name in ["bit-table.csv", "summary.json"] {
        let bytes = |folder: &str| fs::read(desk.path(folder).join(name)).unwrap();
        assert!(bytes("shares") == bytes("whole"), "{name}");
    }
}

/// Ctrl-C keeps all finished results.
#[cfg(unix)]
#[test]
fn an_interrupted_test_goes_on() {
    use std::time::Duration;

    let desk = desk();
    let stopped = bit_test(&["-o", "stopped", "-j", "1", "--set", "bit_test.rpm=300"]);
    let second = || desk.path("stopped").join(POINTS[1]).exists();
    let message = desk.interrupted(&stopped, second, Duration::ZERO);
    let end = "interrupted: partial results are in stopped\n\
               to continue, run the bit test again with --resume\n";
    assert!(message.ends_with(end), "{message}");
    let place = desk.path("stopped");
    assert!(place.join(POINTS[1]).join("checkpoint.bin").exists());
    assert!(!place.join("bit-table.csv").exists());
    let points = summary(&desk, "stopped").points;
    assert!(points.iter().all(|point| point.status == Status::Interrupted));
    desk.done(&[&stopped[..], &["--resume"]].concat());
    assert!(place.join("bit-table.csv").exists());
}

/// A bit that drills at no point has no table: an error, on which `--strict` ends, and a warning if
/// it drills at another point.
#[test]
fn a_bit_that_does_not_drill_is_an_error() {
    let desk = desk();
    let test = |folder: &'static str, weights: &'static str| {
        let weights = ["--set", weights, "--set", "bit_test.rpm=300", "--strict", "--quiet"];
        let mass = ["--set", "bit_test.mass=1000 kg"];
        desk.run(&bit_test(&[&["-o", folder], &weights[..], &mass].concat()))
    };
    let output = test("idle", r#"bit_test.wob=["1 N", "2 N"]"#);
    assert_eq!(output.status.code(), Some(4), "{}", transcript(&output));
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(message, "error: errors were found: bit does not drill\n");
    let idle = |folder: &str| -> Vec<(String, Severity)> {
        let checks = summary(&desk, folder).checks.into_iter();
        let idle = checks.filter(|check| check.kind == CheckKind::BitDoesNotDrill);
        idle.map(|check| (check.sentence, check.severity)).collect()
    };
    let sentence = |weight: &str| format!("wob={weight},rpm=300: the bit does not drill");
    let errors = ["0.001kN", "0.002kN"].map(|weight| (sentence(weight), Severity::Error));
    assert_eq!(idle("idle"), errors);
    let output = test("drills", r#"bit_test.wob=["1 N", "20 kN"]"#);
    assert_eq!(output.status.code(), Some(0), "{}", transcript(&output));
    assert_eq!(idle("drills"), [(sentence("0.001kN"), Severity::Warning)]);
}

/// Mistakes are reported before anything is drilled.
#[test]
fn mistakes_are_told() {
    let desk = desk();
    let answer = |arguments: &[&str]| {
        let output = desk.run(arguments);
        assert_eq!(output.status.code(), Some(2), "{}", transcript(&output));
        transcript(&output)
    };
    let without = ["bit-test", "slant.toml", "-o", "results"];
    assert_snapshot!("bit_test_without_rock", answer(&without));
    assert!(!desk.path("results").exists());
    answer(&bit_test(&["-j", "0"]));
    answer(&bit_test(&["--vary", "rpm=60,70"]));
    answer(&bit_test(&["--set", "bit_test.wob=[\"10 kN\", \"10 kN\"]"]));
    answer(&bit_test(&["--set", "rock.strenght=10 MPa"]));
    let together = ["plot", "results", "results"];
    // The folder of a run.
    let run = ["run", "slant.toml", "-o", "run", "--set", "model=soft"];
    desk.done(&run);
    let of_run = answer(&bit_test(&["-o", "run", "--resume"]));
    assert_snapshot!("bit_test_in_the_folder_of_a_run", of_run);
    // The folder of a test of another rock.
    let quick = args("-o results --quiet --set 'bit_test.wob=10 kN' --set bit_test.rpm=300");
    desk.done(&bit_test(&quick));
    assert_snapshot!("bit_test_overlaid", answer(&together));
    let other = ["--resume", "--set", "rock.density=2600 kg/m3"];
    let of_other = answer(&bit_test(&[&quick[..], &other].concat()));
    assert_snapshot!("bit_test_in_the_folder_of_another", of_other);
}
