//! `calibrate`: readings that cannot be real.
//!
//! The readings are those of a soft string in the well of `CASE` with friction 0.2 in casing and
//! 0.3 in open hole, a block of 250 kN, and noise of 2 to 3 kN and 0.2 kN·m; undamaged they give
//! 0.186 ± 0.010, 0.317 ± 0.013 and 250.9 ± 0.5 kN.

use std::fs;

use wholestring_results::{CalibrationSummary, CheckKind, ReadingCheck};

use crate::desk::{Desk, transcript};

pub(crate) const CASE: &str = r#"name = "Base"
model = "soft"
units = "si"
[well]
stations = [[0,0,0],[600,0,0],[1200,40,30],[3000,40,30]]
path = "minimum-curvature"
[[well.hole]]
kind = "casing"
to = "1500 m"
casing = "9-5/8 in 47 lb/ft"
friction = 0.2
[[well.hole]]
kind = "open"
to = "3000 m"
diameter = "8.5 in"
friction = { kinetic = 0.3, static = 0.36 }
[mud]
density = "1.2 sg"
[[string]]
component = "bit"
od = "8.5 in"
length = "0.3 m"
[[string]]
component = "DC"
od = "6.5 in"
id = "2.8125 in"
length = "181 ft"
mass_per_length = "91 lb/ft"
[[string]]
component = "DP"
catalogue = "5 in 19.50 lb/ft S-135"
length = "to surface"
[bit]
torque = "3 kN.m"
[operation]
kind = ["trip_out","trip_in","rotate_off_bottom","drill"]
rpm = 80
wob = "50 kN"
rop = "10 m/h"
trip_speed = "0.3 m/s"
"#;

const HEAD: &str = "Bit depth (m),Pick-up (kN),Slack-off (kN),Rotating (kN),Torque (kN.m)\n";

/// Depth, pick-up, slack-off and rotating weight, kN, torque, kN·m.
const ROWS: [[f64; 5]; 8] = [
    [1600.0, 733.0, 649.8, 684.0, 3.31],
    [1800.0, 785.9, 673.9, 723.6, 4.50],
    [2000.0, 849.8, 701.6, 768.4, 5.98],
    [2200.0, 909.3, 728.2, 806.1, 7.65],
    [2400.0, 970.3, 762.7, 851.2, 8.89],
    [2600.0, 1033.1, 783.3, 894.4, 10.22],
    [2800.0, 1090.1, 812.9, 935.7, 11.69],
    [3000.0, 1146.3, 838.4, 976.2, 13.18],
];

/// The file of the readings with a change in each row.
pub(crate) fn file(change: impl Fn(usize, [f64; 5]) -> [f64; 5]) -> String {
    let rows = ROWS.iter().enumerate().map(|(place, row)| {
        let cells = change(place, *row).map(|change| change.to_string());
        cells.join(",") + "\n"
    });
    HEAD.to_owned() + &rows.collect::<String>()
}

pub(crate) fn desk(readings: &str) -> Desk {
    let desk = Desk::new();
    fs::write(desk.path("base.toml"), CASE).unwrap();
    fs::write(desk.path("r.csv"), readings).unwrap();
    desk
}

/// Everything that a command printed, on one line.
pub(crate) fn words(output: &std::process::Output) -> String {
    transcript(output).split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A calibration that is refused: its output on one line.
pub(crate) fn refused(readings: &str, more: &[&str]) -> String {
    let desk = desk(readings);
    let output = desk.run(&[&["calibrate", "base.toml", "--data", "r.csv"], more].concat());
    assert_eq!(output.status.code(), Some(2), "{}", transcript(&output));
    words(&output)
}

/// A calibration that succeeds.
pub(crate) fn made(readings: &str, more: &[&str]) -> (CalibrationSummary, String, Desk) {
    let desk = desk(readings);
    let all = [&["calibrate", "base.toml", "--data", "r.csv", "-o", "out"], more].concat();
    let output = desk.done(&all);
    let screen = String::from_utf8(output.stdout).unwrap();
    let summary = CalibrationSummary::read(&desk.path("out/summary.json")).unwrap();
    (summary, screen, desk)
}

fn value(summary: &CalibrationSummary, name: &str) -> f64 {
    summary.estimates.iter().find(|estimate| estimate.parameter == name).unwrap().value
}

#[track_caller]
pub(crate) fn check<'a>(summary: &'a CalibrationSummary, kind: &str) -> &'a ReadingCheck {
    let found = summary.checks.iter().find(|check| check.check.kind.name() == kind);
    found.unwrap_or_else(|| panic!("{kind}: {:#?}", summary.checks))
}

/// Undamaged readings raise only the true warning: two factors that they hardly separate.
#[test]
fn sound_readings_raise_nothing() {
    let (summary, screen, _) = made(&file(|_, row| row), &[]);
    let kinds: Vec<&str> = summary.checks.iter().map(|check| check.check.kind.name()).collect();
    assert_eq!(kinds, ["not_told_apart"], "{:#?}", summary.checks);
    assert!(summary.comparison.is_none());
    // The band is that of the noise: 1.7 times 2.8 kN, at weights of 800 kN.
    assert!(screen.contains("of 32 readings within the band of 90 %: ±4."), "{screen}");
    for (name, expected, error) in [
        ("friction_cased", 0.186, 0.01),
        ("friction_open", 0.317, 0.013),
        ("block_weight_N", 250.9e3, 500.0),
    ] {
        // Half of the last digit of the independent report, and steps of the soft string.
        assert!((value(&summary, name) - expected).abs() < 0.1 * error, "{name}: {summary:?}");
    }
}

#[test]
fn swapped_columns_are_refused() {
    let text =
        refused(&file(|_, [md, up, down, turning, torque]| [md, down, up, turning, torque]), &[]);
    assert!(
        text.contains(
            "the pick-up weight is below the slack-off weight in 8 of 8 rows (lines 2 to 9)"
        ),
        "{text}"
    );
    assert!(text.contains("are the columns swapped?"), "{text}");
}

/// Metres under `ft`.
#[test]
fn depths_in_another_unit_are_refused_with_it() {
    let text = refused(&file(|_, row| row).replace("depth (m)", "depth (ft)"), &[]);
    assert!(text.contains("the bit depths seem not to be in ft"), "{text}");
    assert!(text.contains("a factor of 3.2808") && text.contains("Is the unit m?"), "{text}");
}

/// Pick-up weights alone do not separate the block from two friction factors, and the refusal names
/// what would; one factor is fitted.
#[test]
fn pick_up_weights_alone_do_not_determine_three_numbers() {
    let rows = file(|_, row| row);
    let alone = rows.lines().map(|line| line.split(',').take(2).collect::<Vec<_>>().join(","));
    let alone = alone.collect::<Vec<_>>().join("\n") + "\n";
    let text = refused(&alone, &[]);
    assert!(text.contains("do not determine"), "{text}");
    assert!(text.contains("Give other readings too"), "{text}");
    made(&alone, &["--one-factor"]);
}

/// klbf under `kN`, with the block fitted or fixed; a single column of it; kN under `t`.
#[test]
fn weights_in_another_unit_are_refused_with_it() {
    const KLBF: f64 = 4.448_221_615;
    let all = file(|_, [md, a, b, c, torque]| [md, a / KLBF, b / KLBF, c / KLBF, torque]);
    for more in [&[][..], &["--set=rig.block_weight=250 kN"]] {
        let text = refused(&all, more);
        assert!(
            text.contains("a factor of 4.4482") && text.contains("Is the unit klbf?"),
            "{text}"
        );
    }
    let one = file(|_, [md, a, b, c, torque]| [md, a, b / KLBF, c, torque]);
    let text = refused(&one, &[]);
    assert!(
        text.contains("the slack-off weights seem not to be in kN")
            && text.contains("Is the unit klbf?"),
        "{text}"
    );
    // Kilodecanewtons differ from tonnes by 2 %.
    let kilo_deca = file(|_, [md, a, b, c, torque]| [md, a / 10.0, b / 10.0, c / 10.0, torque]);
    let text = refused(&kilo_deca.replace("(kN)", "(klbf)"), &["--set=rig.block_weight=250 kN"]);
    assert!(text.contains("Is the unit kdaN"), "{text}");
    // A factor of a thousand is not written in per cent.
    let thousand = file(|_, row| row).replace("(kN)", "(N)");
    let text = refused(&thousand, &["--set=rig.block_weight=250 kN"]);
    assert!(
        text.contains("times their values or more") && text.contains("Is the unit kN"),
        "{text}"
    );
    let tonnes = file(|_, row| row).replace("(kN)", "(t)");
    let text = refused(&tonnes, &[]);
    assert!(
        text.contains("the weights seem not to be in t") && text.contains("Is the unit kN?"),
        "{text}"
    );
}

#[test]
fn torques_in_another_unit_are_refused_with_it() {
    for (factor, heading, unit) in [
        (737.562_149, "kN.m", "ft-lbf"),
        (1000.0, "kN.m", "N.m"),
        (1.0, "ft-lbf", "kN.m"),
        (737.562_149, "kgf.m", "ft-lbf"),
    ] {
        let text = file(|_, [md, a, b, c, torque]| [md, a, b, c, factor * torque]);
        let text = text.replace("(kN.m)", &format!("({heading})"));
        let screen = refused(&text, &[]);
        assert!(
            screen.contains("require a friction factor of") && screen.contains(unit),
            "{heading}: {screen}"
        );
    }
    // Foot-pounds in thousands under `kN.m` differ too little to exclude another cause: a warning.
    let text = file(|_, [md, a, b, c, torque]| [md, a, b, c, torque / 1.355_818]);
    let (summary, ..) = made(&text, &[]);
    let check = check(&summary, "unit");
    assert!(check.check.sentence.contains("in kft-lbf instead of kN.m"), "{check:?}");
}

/// Torques in kN.m under `kft-lbf` that scatter by a tenth, of which one depth shows no unit: nearly
/// all are above those of the fit.
#[test]
fn one_sided_torques_are_warned_of_with_their_unit() {
    let scatter = |place: usize| if place.is_multiple_of(2) { 1.1 } else { 0.9 };
    let text = file(|place, [md, a, b, c, torque]| [md, a, b, c, scatter(place) * torque]);
    let (summary, ..) = made(&text.replace("(kN.m)", "(kft-lbf)"), &[]);
    let check = check(&summary, "unit");
    let sentence = &check.check.sentence;
    assert!(
        sentence.starts_with("the torques off bottom are above those of the fit"),
        "{sentence}"
    );
    assert!(sentence.contains("in kN.m instead of kft-lbf they would agree"), "{sentence}");
    let (summary, ..) = made(&text, &[]);
    assert!(summary.checks.iter().all(|check| check.check.kind != CheckKind::ReadingsUnit));
}

/// Weights without the case's block: the message gives the number; the fit gives none.
#[test]
fn a_block_that_the_readings_do_not_hold() {
    let text = file(|_, [md, a, b, c, torque]| [md, a - 250.0, b - 250.0, c - 250.0, torque]);
    let (summary, screen, _) = made(&text, &["--set=rig.block_weight=250 kN"]);
    let found = check(&summary, "block_not_in_readings");
    assert_eq!(found.check.limit, Some(250e3));
    assert!(found.check.value.unwrap().abs() < 10e3, "{found:?}");
    assert!(found.check.sentence.contains("they seem to exclude the block"), "{found:?}");
    assert!(screen.contains("warning: the weights are 2"), "{screen}");
    // Errors of 250 kN exceed those of any instrument, and the count within the band gives its
    // width.
    let errors = check(&summary, "estimated_error");
    assert!(errors.check.value.unwrap() > 200e3, "{errors:?}");
    assert!(summary.status.contains("%) of the rotating weights"), "{}", summary.status);
    let (summary, ..) = made(&text, &["--set=rig.block_weight=250 kN", "--block-weight"]);
    // 0.88 ± 0.52 kN, 0.186 and 0.317.
    assert!((value(&summary, "block_weight_N") - 880.0).abs() < 100.0);
    assert!((value(&summary, "friction_open") - 0.317).abs() < 2e-3);
    check(&summary, "no_block");
    // A block other than the case's.
    let (summary, ..) = made(&file(|_, row| row), &["--set=rig.block_weight=400 kN"]);
    let check = check(&summary, "block_weight");
    assert!((check.check.value.unwrap() - 251e3).abs() < 10e3, "{check:?}");
}

/// Zeros, nulls and negative values are excluded with their lines, and the estimates are those of
/// the others.
#[test]
fn values_that_are_no_readings_are_left_out() {
    let empty = |cell: &str| {
        file(|_, row| row)
            .lines()
            .enumerate()
            .map(|(line, text)| {
                let mut cells: Vec<&str> = text.split(',').collect();
                if line > 3 {
                    cells[2] = cell;
                }
                cells.join(",") + "\n"
            })
            .collect::<String>()
    };
    let (expected, ..) = made(&empty(""), &[]);
    for (cell, kind) in [("0", Some("zero")), ("-999.25", None), ("-712", Some("negative"))] {
        let (summary, screen, _) = made(&empty(cell), &[]);
        assert_eq!(summary.estimates, expected.estimates, "{cell}");
        let words: String = screen.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(words.contains("lines 5 to 9"), "{cell}: {screen}");
        if let Some(kind) = kind {
            assert_eq!(check(&summary, kind).lines.len(), 5, "{cell}");
        }
    }
    // Columns of zeros: pick-up and slack-off alone.
    let (summary, screen, _) = made(&file(|_, [md, a, b, ..]| [md, a, b, 0.0, 0.0]), &[]);
    assert!(screen.contains("the rotating weight is 0 in all 8 rows (lines 2 to 9)"), "{screen}");
    assert!(screen.contains("the torque off bottom is 0 in all 8 rows"), "{screen}");
    for (name, expected, half) in [
        ("friction_cased", 0.196, 5e-4),
        ("friction_open", 0.3, 5e-4),
        ("block_weight_N", 251.5e3, 50.0),
    ] {
        assert!((value(&summary, name) - expected).abs() <= half, "{name}: {summary:?}");
    }
    // A hook load below the block's weight.
    let text =
        file(|place, [md, a, b, c, torque]| [md, a, b, if place == 3 { 120.0 } else { c }, torque]);
    let (summary, ..) = made(&text, &["--set=rig.block_weight=250 kN"]);
    let check = check(&summary, "below_block");
    assert_eq!(
        (check.lines.clone(), check.check.value, check.check.limit),
        (vec!["line 5".into()], Some(120e3), Some(250e3))
    );
    // No reading remains.
    let text = refused(&file(|_, [md, ..]| [md, 0.0, 0.0, 0.0, 0.0]), &[]);
    assert!(text.contains("no weight and no torque is left"), "{text}");
    let text = refused(&file(|_, [md, a, b, c, d]| [md, -a, -b, -c, -d]), &[]);
    assert!(text.contains("in every row that has one (lines 2 to 9)"), "{text}");
}

/// A depth in whole feet that is 15 cm below the end of hole and survey is taken as the end; one
/// that is 1 ft below is refused, in the case's units.
#[test]
fn a_depth_that_is_rounded_beyond_the_end() {
    let text = "Depth (ft),PU Wt (klbs),SO Wt (klbs),ROT Wt (klbs),Off Btm TQ (kft-lbs)\n5249,165,146,154,2.4\n\
        5906,177,151,163,3.3\n6562,191,158,173,4.4\n7218,204,164,181,5.6\n7874,218,171,191,6.6\n\
        8530,232,176,201,7.5\n9186,245,183,210,8.6\n9843,258,188,219,9.7\n";
    let (summary, ..) = made(text, &[]);
    assert_eq!(summary.readings, 32);
    let check = check(&summary, "rounded_depth");
    assert_eq!(
        (check.check.severity.name(), check.lines.clone()),
        ("note", vec!["line 9".to_owned()])
    );
    // Precision that readings rounded to klbf and 0.1 kft·lbf leave of 0.2, 0.3 and 250 kN.
    assert!((value(&summary, "friction_open") - 0.317).abs() < 0.02);
    assert!((value(&summary, "block_weight_N") - 250e3).abs() < 4e3);
    let screen = refused(&text.replace("9843,", "9844,"), &["--set=units=field"]);
    assert!(
        screen
            .contains("the bit is at 9844.0 ft, but hole and survey of its case end at 9842.5 ft"),
        "{screen}"
    );
}

/// With and without outliers: the estimates without them are those of the other readings, and
/// `--without-outliers` applies them.
#[test]
fn outliers_are_named_and_both_fits_are_shown() {
    let wrong = [(2, 1, 969.8), (5, 2, 683.3), (6, 4, 5.8)];
    let damaged = file(|place, mut row| {
        wrong
            .iter()
            .filter(|reading| reading.0 == place)
            .for_each(|reading| row[reading.1] = reading.2);
        row
    });
    let without: String = damaged
        .lines()
        .map(|line| {
            let cells = line.split(',').map(|cell| match cell {
                "969.8" | "683.3" | "5.8" => "",
                cell => cell,
            });
            cells.collect::<Vec<_>>().join(",") + "\n"
        })
        .collect();
    let (expected, ..) = made(&without, &[]);
    let (summary, screen, _) = made(&damaged, &[]);
    let other = summary.comparison.as_ref().unwrap();
    assert_eq!(other.outliers, ["pick-up of line 4", "slack-off of line 7", "torque of line 8"]);
    assert!(!other.left_out && other.loss == "Huber");
    for (one, expected) in other.estimates.iter().zip(&expected.estimates) {
        assert!((one.value / expected.value - 1.0).abs() < 1e-6, "{one:?} {expected:?}");
    }
    assert!(screen.contains("With and without outliers"), "{screen}");
    assert_eq!(
        summary.checks.iter().filter(|check| check.check.kind.name() == "outlier").count(),
        3
    );
    let (summary, _, desk) = made(&damaged, &["--without-outliers"]);
    assert_eq!((summary.readings, summary.held_out), (29, 3));
    for (one, expected) in summary.estimates.iter().zip(&expected.estimates) {
        assert!((one.value / expected.value - 1.0).abs() < 1e-6, "{one:?} {expected:?}");
    }
    assert!(desk.text("out/report.html").contains("With and without outliers"));
}

/// The fragment follows the case: its units, its casing, its static friction; and `check` accepts
/// it with every calibrated case, also with a block that would be negative.
#[test]
fn the_fragment_is_the_case_s() {
    let field = CASE.replace("units = \"si\"", "units = \"field\"");
    for (case, readings, more) in [
        (CASE.to_owned(), file(|_, row| row), &[][..]),
        (field.clone(), file(|_, row| row), &["--friction-around"]),
        (
            field.replace("friction = 0.2", "[well.hole.friction]\nkinetic = 0.2\naround = 0.1"),
            file(|_, row| row),
            &[],
        ),
        // Weights that are 320 kN too small: the block's weight would be negative.
        (
            CASE.to_owned(),
            file(|_, [md, a, b, c, d]| [md, a - 320.0, b - 320.0, c - 320.0, d]),
            &["--one-factor"],
        ),
    ] {
        let desk = desk(&readings);
        fs::write(desk.path("base.toml"), &case).unwrap();
        let all = ["calibrate", "base.toml", "--data", "r.csv", "-o", "out"];
        desk.done(&[&all[..], more].concat());
        let fragment = desk.text("out/friction.toml");
        assert!(fragment.contains("casing = \"9-5/8 in 47 lb/ft\"\n"), "{fragment}");
        assert!(fragment.contains("to = \"1500 m\"\n"), "{fragment}");
        assert!(fragment.contains(", static = 0."), "{fragment}");
        let is_field = case.contains("field");
        assert_eq!(
            fragment.contains(" klbf\""),
            is_field && fragment.contains("[rig]"),
            "{fragment}"
        );
        let tried = fragment.lines().find(|line| line.contains("--set")).unwrap();
        let mut arguments = vec!["check", "base.toml"];
        for change in tried.split('\'').skip(1).step_by(2) {
            arguments.extend(["--set", change]);
        }
        desk.done(&arguments);
        let (before, rest) = case.split_once("[[well.hole]]").unwrap();
        let after = &rest[rest.find("[mud]").unwrap()..];
        fs::write(desk.path("found.toml"), format!("{before}{fragment}\n{after}")).unwrap();
        desk.done(&["check", "found.toml"]);
    }
    let light = file(|_, [md, a, b, c, d]| [md, a - 320.0, b - 320.0, c - 320.0, d]);
    let (summary, ..) = made(&light, &["--one-factor"]);
    let block =
        summary.estimates.iter().find(|estimate| estimate.parameter == "block_weight_N").unwrap();
    assert!(block.at_bound && block.value == 0.0, "{block:?}");
    assert!(check(&summary, "negative").check.sentence.contains("block weight would be negative"));
}

/// A vertical hole does not determine friction, and the message explains this.
#[test]
fn a_vertical_hole_tells_no_friction() {
    let desk = desk(&file(|_, row| row));
    let vertical = CASE.replace("[1200,40,30],[3000,40,30]", "[3000,0,30]");
    fs::write(desk.path("base.toml"), vertical).unwrap();
    let output = desk.run(&["calibrate", "base.toml", "--data", "r.csv"]);
    assert_eq!(output.status.code(), Some(2), "{}", transcript(&output));
    let screen = words(&output);
    assert!(screen.contains("friction has no effect on the readings"), "{screen}");
}

/// Readings for a plan have the same checks.
#[test]
fn readings_of_a_plan_are_checked() {
    let swapped = file(|_, [md, up, down, turning, torque]| [md, down, up, turning, torque]);
    let desk = desk(&swapped);
    fs::write(
        desk.path("base.toml"),
        format!("{CASE}[rig]\nblock_weight = \"250 kN\"\n[plan]\nmeasured = \"r.csv\"\n"),
    )
    .unwrap();
    let output = desk.run(&["check", "base.toml"]);
    assert_eq!(output.status.code(), Some(2), "{}", transcript(&output));
    assert!(words(&output).contains("is below the slack-off weight in 8 of 8 rows"));
    fs::write(desk.path("r.csv"), file(|_, [md, a, b, c, _]| [md, a, b, c, 0.0])).unwrap();
    let output = desk.done(&["check", "base.toml"]);
    assert!(
        words(&output).contains("torque off bottom is 0 in all 8 rows"),
        "{}",
        transcript(&output)
    );
}
