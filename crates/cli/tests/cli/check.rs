//! `check`, `schema` and the command line itself: output and exit status.

use std::{collections::BTreeSet, fs};

use crate::desk::{Desk, transcript};
use insta::assert_snapshot;

#[test]
fn a_sound_case() {
    assert_snapshot!(transcript(&Desk::new().run(&["check", "slant.toml"])));
}

/// For solid rock, the cost of a run and the size of its elements.
#[test]
fn a_case_on_solid_rock() {
    let desk = Desk::new();
    let case = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/rock-300.toml");
    fs::copy(case, desk.path("rock.toml")).unwrap();
    assert_snapshot!(transcript(&desk.run(&["check", "rock.toml"])));
}

/// A pipe is read once: a case is recognised as a case, a survey as a survey.
#[cfg(unix)]
#[test]
fn a_case_and_a_survey_through_a_pipe() {
    use std::{io::Write, process::Stdio};

    let desk = Desk::new();
    let piped = |arguments: &[&str], file: &str| {
        let mut command = desk.command(arguments);
        let command = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().unwrap();
        child.stdin.take().unwrap().write_all(desk.text(file).as_bytes()).unwrap();
        child.wait_with_output().unwrap()
    };
    let case = piped(&["check", "/dev/stdin"], "slant.toml");
    let from_file = desk.done(&["check", "slant.toml"]);
    let text = |output: &[u8]| String::from_utf8_lossy(output).replace("/dev/stdin", "slant.toml");
    assert_eq!(text(&case.stdout), text(&from_file.stdout), "{}", transcript(&case));
    let survey = piped(&["check", "/dev/stdin"], "survey.csv");
    assert!(text(&survey.stdout).contains("a survey of"), "{}", transcript(&survey));
    let run = piped(&["run", "/dev/stdin", "--set", "model=soft", "-q", "-o", "out"], "slant.toml");
    assert!(run.status.success(), "{}", transcript(&run));
    fs::write(desk.path("broken.toml"), "[well]\nstations = [oops").unwrap();
    let broken = piped(&["check", "/dev/stdin"], "broken.toml");
    assert_eq!(broken.status.code(), Some(2));
    assert!(transcript(&broken).contains("oops"), "{}", transcript(&broken));
}

#[test]
fn mistakes_are_underlined() {
    let desk = Desk::new();
    let text = desk.text("slant.toml");
    let text = text.replace("\"1.2 sg\"", "\"1.2 bar\"").replace("rpm", "rmp");
    fs::write(desk.path("slant.toml"), text).unwrap();
    assert_snapshot!(transcript(&desk.run(&["check", "slant.toml"])));
}

#[test]
fn a_mistake_on_the_command_line_is_underlined() {
    let run = Desk::new().run(&["check", "slant.toml", "--set", "friction=-0.3"]);
    assert_snapshot!(transcript(&run));
}

#[test]
fn a_case_that_is_not_there() {
    assert_snapshot!(transcript(&Desk::new().run(&["check", "slent.toml"])));
}

#[test]
fn an_override_that_is_none() {
    assert_snapshot!(transcript(&Desk::new().run(&["check", "slant.toml", "--set", "friction"])));
}

#[test]
fn no_command_shows_the_help() {
    assert_snapshot!(transcript(&Desk::new().run(&[])));
}

#[test]
fn the_help_of_run() {
    assert_snapshot!(transcript(&Desk::new().run(&["run", "--help"])));
}

#[test]
fn the_schema_lists_the_keys_of_a_case() {
    let output = Desk::new().done(&["schema"]);
    let schema: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let keys: BTreeSet<&str> =
        schema["properties"].as_object().unwrap().keys().map(String::as_str).collect();
    for key in [
        "name",
        "model",
        "units",
        "well",
        "mud",
        "steel",
        "string",
        "bit",
        "rig",
        "operation",
        "mesh",
        "dynamics",
    ] {
        assert!(keys.contains(key), "{key} is missing from {keys:?}");
    }
}

/// A file is recognised by its content: a case by any name, valid or not, and a survey named like a
/// case.
#[test]
fn a_case_is_known_by_its_content() {
    let desk = Desk::new();
    let sound = transcript(&desk.run(&["check", "slant.toml"])).replace("slant.toml", "slant.case");
    fs::copy(desk.path("slant.toml"), desk.path("slant.case")).unwrap();
    assert_eq!(transcript(&desk.run(&["check", "slant.case"])), sound);
    let wrong = desk.text("slant.toml").replace("\"1.2 sg\"", "\"1.2 bar\"");
    fs::write(desk.path("wrong"), wrong).unwrap();
    assert!(transcript(&desk.run(&["check", "wrong"])).contains("1.2 bar"));
    fs::copy(desk.path("survey.csv"), desk.path("survey.toml")).unwrap();
    let survey = transcript(&desk.done(&["check", "survey.toml"]));
    assert!(survey.contains("survey.toml: a survey of"), "{survey}");
    // Content that is neither is read according to the file's name.
    fs::write(desk.path("none.toml"), "nothing at all").unwrap();
    let none = transcript(&desk.run(&["check", "none.toml"]));
    assert!(none.contains("none.toml:1"), "{none}");
}

/// An unlikely value is reported with its likely meaning; a number that has lost its quotes to the
/// shell is refused.
#[test]
fn a_number_without_its_unit() {
    let desk = Desk::new();
    let text = desk.text("slant.toml");
    fs::write(desk.path("bare.toml"), text.replace("\"1.2 sg\"", "10.8")).unwrap();
    assert_snapshot!("a_density_of_ppg", transcript(&desk.run(&["check", "bare.toml"])));
    let lost = desk.run(&["check", "slant.toml", "--set", "mud.density=9.5"]);
    assert_snapshot!("a_density_without_unit", transcript(&lost));
    let range = "bit_depth=300..900/300";
    let range = desk.run(&["sweep", "slant.toml", "--vary", range, "--set", "model=soft"]);
    assert_snapshot!("a_range_without_unit", transcript(&range));
}

/// The warnings on readings are those of a calibration, and so are its refusals.
#[test]
fn readings_are_checked_as_by_calibrate() {
    let desk = Desk::new();
    let file = |rows: &str| {
        let head = "Bit depth (m),Pick-up (kN),Slack-off (kN),Torque (kN.m)\n";
        fs::write(desk.path("r.csv"), format!("{head}{rows}")).unwrap();
        let output = desk.run(&["check", "r.csv"]);
        (output.status.code(), transcript(&output))
    };
    let (status, text) = file("1000,300,200,3\n1100,-310,205,-3.2\n1200,320,330,3.5\n");
    assert_eq!(status, Some(0), "{text}");
    for warning in [
        "warning: the pick-up weight is -310 kN in line 3, 1 of 3 rows",
        "warning: the torque off bottom is -3.2 kN.m in line 3",
        "warning: the pick-up weight is below the slack-off weight in 1 of 2 rows (line 4)",
    ] {
        assert!(text.contains(warning), "{text}");
    }
    let (status, text) = file("1000,200,300,3\n1100,205,310,3.2\n");
    assert_eq!(status, Some(2), "{text}");
    assert!(text.contains("error: r.csv: the pick-up weight is below the slack-off"), "{text}");
    let (status, text) = file("1000,300,200,3\n1100,310,205,3.2\n");
    assert!(status == Some(0) && !text.contains("warning"), "{text}");
}
