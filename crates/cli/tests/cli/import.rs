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

/// A case that is written in a format and read again is the same, as far as the format writes digits:
/// eight significant ones, in a report hundredths of a unit of length and thousandths of a degree.
#[test]
fn what_is_exported_is_imported() {
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slant.toml");
    let desk = Desk::new();
    fs::copy(own, desk.path("well.toml")).unwrap();
    let known = wholestring_case::load(&desk.path("well.toml"), &[]).unwrap();
    for (survey, tally, units) in [
        ("csv", "csv", "field"),
        ("xlsx", "xlsx", "si"),
        ("text", "csv", "field"),
        ("witsml", "witsml", "field"),
        ("witsml", "witsml", "si"),
        ("witsml2", "witsml2", "field"),
    ] {
        let names = [format!("{survey}-{units}.survey"), format!("{tally}-{units}.tally")];
        for (what, format, name) in [("survey", survey, &names[0]), ("tally", tally, &names[1])] {
            let export = ["export", "well.toml", "--what", what, "--to", format, "--units", units];
            desk.done(&[&export[..], &["-o", name]].concat());
        }
        let case = format!("{survey}-{units}.toml");
        desk.done(&["import", &names[0], &names[1], "-o", &case]);
        // What neither of the two holds.
        let hole = "\n[[well.hole]]\nkind = \"open\"\nto = \"1300 m\"\ndiameter = \"9 in\"\nfriction = 0.3\n\
                    [mud]\ndensity = \"1.1 sg\"\n";
        let text = desk.text(&case).replace("\n[operation]\n", &format!("{hole}\n[operation]\n"));
        fs::write(desk.path(&case), text).unwrap();
        let read = wholestring_case::load(&desk.path(&case), &[]).unwrap();

        let stations = known.model.well.path.stations().iter().zip(read.model.well.path.stations());
        let (length_m, angle_rad) = match survey {
            "text" => (0.005 * 0.3048, 0.0005_f64.to_radians()),
            // The eighth digit of thousands of feet.
            _ => (0.5e-4 * 0.3048, 1e-8),
        };
        assert_eq!(known.model.well.path.stations().len(), read.model.well.path.stations().len());
        for (ours, theirs) in stations {
            assert!(
                (ours.md_m - theirs.md_m).abs() <= length_m * 1.001,
                "{survey}: {ours:?} {theirs:?}"
            );
            let [inclination, azimuth] = [
                ours.inclination_rad - theirs.inclination_rad,
                ours.azimuth_rad - theirs.azimuth_rad,
            ];
            assert!(inclination.abs() <= angle_rad * 1.001, "{survey}: {ours:?} {theirs:?}");
            assert!(azimuth.abs() <= angle_rad * 1.001, "{survey}: {ours:?} {theirs:?}");
        }
        let [ours, theirs] = [&known, &read].map(|case| case.model.string.components());
        assert_eq!(ours.len(), theirs.len(), "{tally}");
        for (ours, theirs) in ours.iter().zip(theirs) {
            for (ours, theirs, what) in [
                (ours.od_m, theirs.od_m, "od"),
                (ours.id_m, theirs.id_m, "id"),
                (ours.mass_per_length_kg_per_m, theirs.mass_per_length_kg_per_m, "mass"),
                (ours.length_m, theirs.length_m, "length"),
            ] {
                // Eight digits in a file, and lengths that end at the bit's depth.
                let near = 1e-6 * ours.abs().max(1e-3);
                assert!((ours - theirs).abs() <= near, "{tally}, {units}: {what} {ours} {theirs}");
            }
        }
    }
}
