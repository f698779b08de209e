//! `survey`: positions and dogleg severity, from closed forms.

use std::fs;

use crate::desk::{Desk, args, transcript};
use insta::assert_snapshot;

/// A row of the result by column.
struct Row {
    md_m: f64,
    tvd_m: f64,
    north_m: f64,
    east_m: f64,
    dogleg_deg_per_30m: f64,
}

fn rows(csv: &str) -> Vec<Row> {
    csv.lines()
        .skip(1)
        .map(|line| {
            let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
            let [md_m, _, _, tvd_m, north_m, east_m, dogleg_deg_per_30m] = cells[..] else {
                panic!("seven cells in {line}");
            };
            Row { md_m, tvd_m, north_m, east_m, dogleg_deg_per_30m }
        })
        .collect()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// The survey builds 3 deg per 100 ft from 1000 ft: an arc of radius 18000/(3 pi) ft.
fn arc(feet: f64) -> (f64, f64) {
    let radius_m = 100.0 * 0.3048 / 3.0_f64.to_radians();
    let angle = (3.0 * feet / 100.0).to_radians();
    (radius_m * angle.sin(), radius_m * (1.0 - angle.cos()))
}

#[test]
fn what_is_printed() {
    assert_snapshot!(transcript(&Desk::new().run(&["survey", "survey.csv"])));
}

/// Positions are printed to a micrometre.
#[test]
fn positions_are_those_of_the_arc() {
    let output = Desk::new().run(&["survey", "survey.csv", "--units", "si"]);
    let rows = rows(&text(&output.stdout));
    assert_eq!(rows.len(), 5);
    let half = 0.5_f64.sqrt();
    for (row, feet) in rows[1..4].iter().zip([0.0, 100.0, 200.0]) {
        let (down, out) = arc(feet);
        assert!((row.tvd_m - 304.8 - down).abs() < 1e-6, "{feet}");
        assert!((row.north_m - out * half).abs() < 1e-6, "{feet}");
        assert!((row.east_m - out * half).abs() < 1e-6, "{feet}");
    }
    let severities: Vec<f64> = rows.iter().map(|row| row.dogleg_deg_per_30m).collect();
    let build = 3.0 * 30.0 / 30.48;
    for (severity, expected) in severities.iter().zip([0.0, 0.0, build, build, 0.0]) {
        assert!((severity - expected).abs() < 1e-6, "{severities:?}");
    }
}

/// A listing in feet has its result and its notes in feet, and reads back as the same survey.
#[test]
fn results_are_in_the_units_of_the_survey() {
    let desk = Desk::new();
    let output = desk.done(&["survey", "survey.csv"]);
    let field = text(&output.stdout);
    let header = "md_ft,inclination_deg,azimuth_deg,tvd_ft,north_ft,east_ft,\
                  dogleg_severity_deg_per_100ft\n";
    assert!(field.starts_with(header), "{field}");
    // The arc of 3 deg per 100 ft.
    let severities: Vec<f64> = rows(&field).iter().map(|row| row.dogleg_deg_per_30m).collect();
    for (severity, expected) in severities.iter().zip([0.0, 0.0, 3.0, 3.0, 0.0]) {
        assert!((severity - expected).abs() < 1e-6, "{severities:?}");
    }
    fs::write(desk.path("again.csv"), &field).unwrap();
    let again = desk.done(&["survey", "again.csv"]);
    assert_eq!(text(&again.stdout), field);
    let notes = text(&again.stderr);
    assert!(notes.contains("positions by minimum curvature agree"), "{notes}");
    assert!(!notes.contains(" m\n") && !notes.contains(" m,"), "{notes}");
}

#[test]
fn rows_between_stations() {
    let desk = Desk::new();
    let output = desk.run(&args("survey survey.csv --units si --step '100 ft' -o positions.csv"));
    assert!(output.status.success() && output.stdout.is_empty());
    let stepped = rows(&desk.text("positions.csv"));
    // Every station is a multiple of the step: none occurs twice.
    let depths: Vec<f64> = stepped.iter().map(|row| row.md_m).collect();
    assert_eq!(depths.len(), 21);
    assert!(depths.windows(2).all(|pair| (pair[1] - pair[0] - 30.48).abs() < 1e-6));
}

#[test]
fn both_paths_take_the_surveys_directions() {
    let desk = Desk::new();
    for path in ["minimum-curvature", "spline"] {
        let output = desk.run(&["survey", "survey.csv", "--units", "si", "--path", path]);
        let text = text(&output.stdout);
        let last = text.lines().last().unwrap();
        let cells: Vec<&str> = last.split(',').collect();
        assert_eq!(&cells[..3], ["609.600000", "6.000000", "45.000000"], "{path}");
    }
}

/// The command reads its own output, to the last printed digit.
#[test]
fn reads_its_own_result() {
    let desk = Desk::new();
    desk.done(&["survey", "survey.csv", "-o", "first.csv"]);
    desk.done(&["survey", "first.csv", "-o", "second.csv"]);
    let [first, second] = ["first.csv", "second.csv"].map(|name| rows(&desk.text(name)));
    for (a, b) in first.iter().zip(&second) {
        assert!((a.tvd_m - b.tvd_m).abs() < 2e-6 && (a.north_m - b.north_m).abs() < 2e-6);
    }
}

#[test]
fn a_mistake_is_underlined() {
    let desk = Desk::new();
    fs::write(desk.path("bad.csv"), "MD (m),Inc,Azi\n0,0,0\n30,x,0\n").unwrap();
    assert_snapshot!(transcript(&desk.run(&["survey", "bad.csv"])));
}

#[test]
fn a_survey_that_is_not_there() {
    assert_snapshot!(transcript(&Desk::new().run(&["survey", "nowhere.csv"])));
}

#[test]
fn a_result_that_cannot_be_written() {
    let output = Desk::new().run(&["survey", "survey.csv", "-o", "no/such/folder.csv"]);
    assert_eq!(output.status.code(), Some(3));
    assert!(text(&output.stderr).contains("error: cannot write no/such/folder.csv"));
}

#[test]
fn a_step_that_is_none() {
    for step in ["0 m", "-10 m", "10", "10 kg", "NaN m", "1e-9 m"] {
        let argument = format!("--step={step}");
        let output = Desk::new().run(&["survey", "survey.csv", &argument]);
        assert_eq!(output.status.code(), Some(2), "{step}");
    }
}

/// The desk's case with its survey in a file.
fn with_survey(desk: &Desk, survey: &str) {
    fs::write(desk.path("own.csv"), survey).unwrap();
    let case = desk.text("slant.toml");
    let case = case.replace("stations = [[0, 60, 0], [600, 60, 0]]", "survey = \"own.csv\"");
    fs::write(desk.path("own.toml"), case).unwrap();
}

/// A survey that begins at 500 m without other information begins 500 m below the origin, alone as
/// in a case. An inclined hole does not lead there from the wellhead: a case refuses it.
#[test]
fn a_first_station_below_the_surface_lies_as_deep_everywhere() {
    let desk = Desk::new();
    with_survey(&desk, "MD (m),Inc,Azi\n500,4,0\n600,4,0\n");
    let output = desk.run(&["survey", "own.csv"]);
    let rows = rows(&text(&output.stdout));
    assert_eq!((rows[0].md_m, rows[0].tvd_m), (500.0, 500.0));
    let note = "the first station is at 500 m";
    assert!(text(&output.stderr).contains(note));
    let check = desk.run(&["check", "own.toml"]);
    assert!(text(&check.stdout).contains(note), "{}", transcript(&check));
    with_survey(&desk, "MD (m),Inc,Azi\n500,60,0\n600,60,0\n");
    let refused = desk.run(&["check", "own.toml"]);
    assert_eq!(refused.status.code(), Some(2), "{}", transcript(&refused));
    assert!(text(&refused.stderr).contains("the hole from the surface to there is not given"));
    let warned = desk.run(&["survey", "own.csv"]);
    assert!(text(&warned.stderr).contains("warning"), "{}", transcript(&warned));
}

/// All commands refuse it without units, until they are given.
#[test]
fn a_survey_without_units_is_refused_by_all_alike() {
    let desk = Desk::new();
    with_survey(&desk, "0,60,0\n2000,60,0\n");
    let units = ["--set", "well.survey_unit=ft"];
    for command in [
        &["check", "own.toml"][..],
        &["run", "own.toml", "--quiet", "--set", "model=soft", "-o", "r"],
    ] {
        let refused = desk.run(command);
        assert_eq!(refused.status.code(), Some(2), "{}", transcript(&refused));
        assert!(text(&refused.stderr).contains("survey_unit = \"m\""));
        desk.done(&[command, &units[..]].concat());
    }
    let refused = desk.run(&["survey", "own.csv"]);
    assert_eq!(refused.status.code(), Some(2), "{}", transcript(&refused));
    assert!(text(&refused.stderr).contains("--unit m"));
    let accepted = desk.done(&["survey", "own.csv", "--unit", "ft"]);
    assert!(text(&accepted.stdout).starts_with("md_ft,"));
    let accepted = desk.done(&["survey", "own.csv", "--unit", "ft", "--units", "si"]);
    assert_eq!(rows(&text(&accepted.stdout))[1].md_m, 2000.0 * 0.3048);
}

/// Turns that no hole makes are reported in their row: 180 deg is refused, a likely slip gives a
/// warning.
#[test]
fn turns_are_pointed_out_in_the_file() {
    let desk = Desk::new();
    fs::write(desk.path("back.csv"), "MD (m),Inc (deg),Azi (deg)\n0,0,0\n100,180,0\n900,180,0\n")
        .unwrap();
    let refused = text(&desk.run(&["survey", "back.csv"]).stderr);
    assert!(refused.contains("back.csv:3:1") && refused.contains("turns by 180 deg"), "{refused}");
    fs::write(
        desk.path("slip.csv"),
        "MD (m),Inc,Azi\n0,0,45\n1200,40,45\n1230,4.1,45\n1260,41,45\n",
    )
    .unwrap();
    let output = desk.run(&["survey", "slip.csv"]);
    let warned = text(&output.stderr);
    assert!(output.status.success(), "{warned}");
    assert!(
        warned.contains("slip.csv:4:1") && warned.contains("is 4.1 a typing error for 41?"),
        "{warned}"
    );
}

/// A case in place of a survey is reported as a case, with the command that writes its survey.
#[test]
fn a_case_is_no_survey() {
    let desk = Desk::new();
    let output = desk.run(&["survey", "slant.toml"]);
    assert_eq!(output.status.code(), Some(2));
    let text = transcript(&output);
    assert!(text.contains("slant.toml is a case file"), "{text}");
    assert!(text.contains("wholestring export --to csv --what survey slant.toml"), "{text}");
}
