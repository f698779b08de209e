//! `import`, and `check` of the files of other programs.

use std::{fs, path::Path};

use insta::assert_snapshot;

use crate::desk::{Desk, transcript};

/// A folder with these samples in it.
fn desk(samples: &[&str]) -> Desk {
    let desk = Desk::new();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../import/tests/samples");
    for sample in samples {
        let name = Path::new(sample).file_name().unwrap();
        fs::copy(folder.join(sample), desk.path(name.to_str().unwrap())).unwrap();
    }
    desk
}

/// A part of a case: what it lacks is said, on the screen and in the file.
#[test]
fn a_survey_alone() {
    let desk = desk(&["own/survey-wellpath-report.txt"]);
    let import = ["import", "survey-wellpath-report.txt"];
    assert_snapshot!("import_survey", transcript(&desk.run(&import)));
    assert_snapshot!(
        "import_survey_written",
        transcript(&desk.run(&[&import[..], &["-o", "well.toml"]].concat()))
    );
    // What is missing is found by the check of the case, too.
    assert_eq!(desk.run(&["check", "well.toml"]).status.code(), Some(2));
    // Nothing is written over.
    assert_snapshot!(
        "import_survey_again",
        transcript(&desk.run(&[&import[..], &["-o", "well.toml"]].concat()))
    );
}

/// From WITSML to a plan in two commands.
#[test]
fn witsml_to_a_plan() {
    let files = ["trajectory", "tubular", "wbgeometry", "bharun"];
    let files = files.map(|object| format!("own/witsml-{object}.xml"));
    let desk = desk(&files.each_ref().map(String::as_str));
    let names = files.each_ref().map(|file| file.trim_start_matches("own/"));
    let import = [&["import"][..], &names, &["-o", "well.toml"]].concat();
    assert_snapshot!("import_witsml", transcript(&desk.run(&import)));
    desk.done(&["plan", "well.toml", "-o", "plan"]);
    assert!(desk.path("plan/plan.xlsx").is_file());
}

/// From an EDM export to a plan in two commands; what it does not tell is asked for.
#[test]
fn edm_to_a_plan() {
    let desk = desk(&["own/edm-well.xml"]);
    let import = ["import", "edm-well.xml", "-o", "well.toml"];
    assert_snapshot!("import_edm_wells", transcript(&desk.run(&import)));
    let picked = ["--pick", "wellbore=WS-1", "--pick", "case=8 1/2 in drilling"];
    let picked = [&import[..], &["--pick", "well=WS-1"], &picked].concat();
    assert_snapshot!("import_edm_units", transcript(&desk.run(&picked)));
    let said = [&picked[..], &["--unit", "edm=api"]].concat();
    assert_snapshot!("import_edm", transcript(&desk.run(&said)));
    desk.done(&["plan", "well.toml", "-o", "plan"]);
}

/// Options that nobody asked for, that say nothing, or that are said twice.
#[test]
fn options_that_say_nothing() {
    let desk = desk(&["own/survey-wellpath-report.txt"]);
    let said = |options: &[&str]| {
        let import = [&["import", "survey-wellpath-report.txt"], options].concat();
        let output = desk.run(&import);
        assert_eq!(output.status.code(), Some(2), "{}", transcript(&output));
        String::from_utf8(output.stderr).unwrap()
    };
    let unused = said(&["--pick", "tubular=BHA 7"]);
    assert!(unused.contains("--pick tubular says nothing that a file asks for"), "{unused}");
    let twice = said(&["--unit", "md=ft", "--unit", "md=m"]);
    assert!(twice.contains("--unit md= is given twice"), "{twice}");
    let empty = said(&["--unit", "md="]);
    assert!(empty.contains("expected a name, `=` and a value"), "{empty}");
    let wrong = said(&["--unit", "md=psi"]);
    assert!(wrong.contains("expected a unit of length"), "{wrong}");
}

/// What a file is, of each format.
#[test]
fn files_are_told_apart() {
    let samples = [
        "own/survey-wellpath-report.txt",
        "own/witsml-tubular.xml",
        "witsml-2.0/hashmap-trajectory20.xml",
        "own/edm-well.xml",
    ];
    let desk = desk(&samples);
    let checks = samples.map(|sample| {
        let name = sample.rsplit('/').next().unwrap();
        transcript(&desk.run(&["check", name]))
    });
    assert_snapshot!("check_of_others", checks.join("\n"));
}
