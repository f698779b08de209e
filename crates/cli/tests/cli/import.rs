//! `import`, and `check` of the files of other programs.

use std::{fs, path::Path};

use insta::assert_snapshot;
use wholestring::{string::Component, well::Path as WellPath};
use wholestring_import::{Choices, ImportErrorKind, Input, log};
use wholestring_results::{PlanPoint, PlanSummary};

use crate::desk::{Desk, transcript};

/// A folder that contains these samples.
fn desk(samples: &[&str]) -> Desk {
    let desk = Desk::new();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../import/tests/samples");
    for sample in samples {
        let name = Path::new(sample).file_name().unwrap();
        fs::copy(folder.join(sample), desk.path(name.to_str().unwrap())).unwrap();
    }
    desk
}

/// A part of a case: its missing parts are listed, on the screen and in the file.
#[test]
fn a_survey_alone() {
    let desk = desk(&["own/survey-wellpath-report.txt"]);
    let import = ["import", "survey-wellpath-report.txt"];
    assert_snapshot!("import_survey", transcript(&desk.run(&import)));
    assert_snapshot!(
        "import_survey_written",
        transcript(&desk.run(&[&import[..], &["-o", "well.toml"]].concat()))
    );
    // The missing parts are found by the check of the case, too.
    assert_eq!(desk.run(&["check", "well.toml"]).status.code(), Some(2));
    // Nothing is overwritten.
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

/// From an EDM export to a plan in two commands; missing values are requested.
#[test]
fn edm_to_a_plan() {
    let desk = desk(&["own/edm-well.xml"]);
    let import = ["import", "edm-well.xml", "-o", "well.toml"];
    assert_snapshot!("import_edm_wells", transcript(&desk.run(&import)));
    let picked = ["--pick", "wellbore=WS-1", "--pick", "case=8 1/2 in drilling"];
    let picked = [&import[..], &["--pick", "well=WS-1"], &picked].concat();
    assert_snapshot!("import_edm_units", transcript(&desk.run(&picked)));
    let arguments = [&picked[..], &["--unit", "edm=api"]].concat();
    assert_snapshot!("import_edm", transcript(&desk.run(&arguments)));
    // Its own drag chart overlays the plan.
    let plan = desk.done(&["plan", "well.toml", "--overlay", "well-overlay.csv", "-o", "plan"]);
    let stdout = String::from_utf8(plan.stdout).unwrap();
    assert!(stdout.contains("well-overlay.csv: ours less theirs, "), "{stdout}");
    let summary = desk.text("plan/summary.json");
    assert!(summary.contains("well-overlay.csv"), "{summary}");
}

/// Options that were not requested, that are empty, or that are given twice.
#[test]
fn options_that_say_nothing() {
    let desk = desk(&["own/survey-wellpath-report.txt"]);
    let refusal = |options: &[&str]| {
        let import = [&["import", "survey-wellpath-report.txt"], options].concat();
        let output = desk.run(&import);
        assert_eq!(output.status.code(), Some(2), "{}", transcript(&output));
        String::from_utf8(output.stderr).unwrap()
    };
    let unused = refusal(&["--pick", "tubular=BHA 7"]);
    assert!(unused.contains("no file uses --pick tubular"), "{unused}");
    let twice = refusal(&["--unit", "md=ft", "--unit", "md=m"]);
    assert!(twice.contains("--unit md= is given twice"), "{twice}");
    let empty = refusal(&["--unit", "md="]);
    assert!(empty.contains("expected a name, `=` and a value"), "{empty}");
    let wrong = refusal(&["--unit", "md=psi"]);
    assert!(wrong.contains("expected a unit of length"), "{wrong}");
}

/// Detection of each file format.
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

/// The shipped slant well with features that a round trip may lose: a stabiliser with short blades,
/// tool joints of its own, a strength, and a path that does not begin under the origin.
fn rich_case(desk: &Desk) {
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slant.toml");
    let text = fs::read_to_string(own).unwrap();
    let tie_in =
        "[well.tie_in]\nnorth = \"12.5 m\"\neast = \"-30.25 m\"\ntvd = \"8 m\"\n\n[[well.hole]]";
    let more = "[[string]]\ncomponent = \"stabiliser\"\nod = \"6.5 in\"\nid = \"2.8125 in\"\nlength = \"1.5 m\"\n\
                blade_od = \"8.4 in\"\n\n[[string]]\ncomponent = \"heavy-weight drill pipe\"";
    let pipe = "[[string]]\ncomponent = \"own drill pipe\"\nod = \"5 in\"\nid = \"4.276 in\"\nlength = \"200 m\"\n\
                mass_per_length = \"34 kg/m\"\njoint_od = \"6.5 in\"\njoint_spacing = \"9.25 m\"\n\
                yield_strength = \"724 MPa\"\n\n[[string]]\ncomponent = \"drill pipe\"";
    let text = text.replacen("[[well.hole]]", tie_in, 1);
    let text = text.replace("[[string]]\ncomponent = \"heavy-weight drill pipe\"", more);
    fs::write(desk.path("well.toml"), text.replace("[[string]]\ncomponent = \"drill pipe\"", pipe))
        .unwrap();
}

/// A case that is written in a format and read again is the same, to the digits of the format:
/// eight significant ones, in a report hundredths of a unit of length and thousandths of a degree.
#[test]
fn what_is_exported_is_imported() {
    let desk = Desk::new();
    rich_case(&desk);
    let known = wholestring_case::load(&desk.path("well.toml"), &[]).unwrap();
    let joints = known
        .model
        .string
        .components()
        .iter()
        .filter(|component| component.joints.is_some())
        .count();
    assert!(
        joints >= 2
            && known.model.string.components().iter().any(|component| component.blades.is_some())
    );
    for (survey, tally, units) in [
        ("csv", "csv", "field"),
        ("xlsx", "xlsx", "si"),
        ("xlsx", "xlsx", "field"),
        ("text", "csv", "field"),
        ("text", "csv", "si"),
        ("witsml", "witsml", "field"),
        ("witsml", "witsml", "si"),
        ("witsml2", "witsml2", "field"),
        ("witsml2", "witsml2", "si"),
        ("witsml21", "witsml21", "field"),
        ("witsml21", "witsml21", "si"),
    ] {
        let names = [format!("{survey}-{units}.survey"), format!("{tally}-{units}.tally")];
        for (what, format, name) in [("survey", survey, &names[0]), ("tally", tally, &names[1])] {
            let export = ["export", "well.toml", "--what", what, "--to", format, "--units", units];
            desk.done(&[&export[..], &["-o", name]].concat());
        }
        let case = format!("{survey}-{units}.toml");
        desk.done(&["import", &names[0], &names[1], "-o", &case]);
        // Missing from both files.
        let hole = "\n[[well.hole]]\nkind = \"open\"\nto = \"1300 m\"\ndiameter = \"9 in\"\nfriction = 0.3\n\
                    [mud]\ndensity = \"1.1 sg\"\n";
        let text = desk.text(&case).replace("\n[operation]\n", &format!("{hole}\n[operation]\n"));
        fs::write(desk.path(&case), text).unwrap();
        let read = wholestring_case::load(&desk.path(&case), &[]).unwrap();
        let unit_m = if units == "field" { 0.3048 } else { 1.0 };
        let (length_m, angle_rad) = match survey {
            "text" => (0.005 * unit_m, 0.0005_f64.to_radians()),
            // The eighth digit of thousands.
            _ => (0.5e-4 * unit_m, 1e-8),
        };
        same_path(&known.model.well.path, &read.model.well.path, length_m, angle_rad, survey);
        let [ours, theirs] = [&known, &read].map(|case| case.model.string.components());
        same_string(ours, theirs, &format!("{tally}, {units}"), tally.starts_with("witsml"));
    }
}

#[track_caller]
fn same_path(ours: &WellPath, theirs: &WellPath, length_m: f64, angle_rad: f64, format: &str) {
    let near = |a: f64, b: f64, by: f64, what: &str| {
        assert!((a - b).abs() <= by * 1.001, "{format}: {what} {a} {b}");
    };
    assert_eq!(ours.stations().len(), theirs.stations().len());
    for (a, b) in ours.stations().iter().zip(theirs.stations()) {
        near(a.md_m, b.md_m, length_m, "measured depth");
        near(a.inclination_rad, b.inclination_rad, angle_rad, "inclination");
        near(a.azimuth_rad, b.azimuth_rad, angle_rad, "azimuth");
    }
    let [a, b] = [ours, theirs].map(|path| path.at(path.first_md_m()).position_m);
    near(a.x, b.x, length_m, "north of the first station");
    near(a.y, b.y, length_m, "east of the first station");
    near(a.z, b.z, length_m, "depth of the first station");
}

/// Compares the components of two strings. A tally has no length of blades, which are assumed over
/// the full length.
#[track_caller]
fn same_string(ours: &[Component], theirs: &[Component], format: &str, has_blades: bool) {
    assert_eq!(ours.len(), theirs.len(), "{format}");
    for (a, b) in ours.iter().zip(theirs) {
        let properties = |c: &Component| {
            let blades_m = c.blades.map(|blades| blades.length_m).filter(|_| has_blades);
            [
                ("od", Some(c.od_m)),
                ("id", Some(c.id_m)),
                ("mass", Some(c.mass_per_length_kg_per_m)),
                ("length", Some(c.length_m)),
                ("joint_od", c.joints.map(|joints| joints.od_m)),
                ("joint_spacing", c.joints.map(|joints| joints.spacing_m)),
                ("blade_od", c.blades.map(|blades| blades.od_m)),
                ("blade_length", blades_m),
                ("yield_strength", c.yield_strength_Pa),
            ]
        };
        for ((what, ours), (_, theirs)) in properties(a).into_iter().zip(properties(b)) {
            // Eight digits in a file, and lengths that end at the bit's depth.
            let near = 1e-6 * ours.unwrap_or(0.0).abs().max(1e-3);
            let is_same = match (ours, theirs) {
                (Some(ours), Some(theirs)) => (ours - theirs).abs() <= near,
                (None, None) => true,
                _ => false,
            };
            assert!(is_same, "{format}: {what} of {}: {ours:?} {theirs:?}", a.name);
        }
    }
}

/// Results of a plan as a WITSML log are read as one: weights and torques against bit depth.
#[test]
fn a_log_that_is_exported_is_read() {
    let desk = Desk::new();
    rich_case(&desk);
    desk.done(&["plan", "well.toml", "-o", "plan"]);
    let summary = PlanSummary::read(&desk.path("plan/summary.json")).unwrap();
    let formats = ["witsml", "witsml2", "witsml21"];
    for (format, units) in
        formats.into_iter().flat_map(|format| [(format, "si"), (format, "field")])
    {
        let name = format!("{format}-{units}.xml");
        let export = ["export", "plan", "--to", format, "--units", units, "-o", &name];
        desk.done(&export);
        let text = desk.text(&name);
        let open = |choices: &Choices| log(Input::of_bytes(&name, text.as_bytes()), choices);
        // The file contains several: one is picked.
        let names = match open(&Choices::default()).map_err(|error| error.kind().clone()) {
            Err(ImportErrorKind::Ambiguous { names, .. }) => names,
            other => panic!("{:?}", other.err()),
        };
        assert!(names.len() > 4, "{names:?}");
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-7 * b.abs().max(1.0);
        let (mut rows, mut finite) = (0, 0);
        for picked in &names {
            for row in open(&Choices::default().pick("log", picked)).unwrap() {
                let row = row.unwrap();
                let is_it = |point: &&PlanPoint| {
                    let (load_N, torque_N_m) = match &point.scalars {
                        Some(point) => (point.hook_load_N, point.surface_torque_N_m),
                        None => (f64::NAN, f64::NAN),
                    };
                    let same = |a: f64, b: f64| near(a, b) || a.is_nan() && b.is_nan();
                    near(row.bit_depth_m, point.bit_depth_m)
                        && same(row.hook_load_N, load_N)
                        && same(row.torque_N_m, torque_N_m)
                };
                assert!(summary.points.iter().any(|point| is_it(&point)), "{picked}: {row:?}");
                assert!(row.time_s.is_nan());
                rows += 1;
                finite += usize::from(row.hook_load_N.is_finite());
            }
        }
        assert_eq!(rows, summary.points.len(), "{name}");
        assert!(finite > rows / 2, "{finite} of {rows}");
    }
}
