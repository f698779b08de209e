//! `export`: results, the survey and the string in the formats of other programs.

use std::fs;

use crate::desk::{Desk, args, text, transcript};

#[test]
fn a_run_as_csv_excel_and_witsml() {
    let desk = Desk::new();
    desk.done(&args("run slant.toml --set model=soft --quiet -o out"));
    let done = desk.done(&args("export out --to csv"));
    assert!(text(&done.stdout).contains("export/operations.csv"), "{}", transcript(&done));
    let csv = desk.text("out/export/operations.csv");
    let mut lines = csv.lines();
    let head = lines.next().unwrap();
    assert!(head.starts_with("model,operation,bit depth (m),"), "{head}");
    assert!(head.contains("hook load (kN)"), "{head}");
    assert!(lines.next().unwrap().starts_with("soft,trip out,600,"), "{csv}");
    assert!(desk.path("out/export/nodes.csv").is_file());

    desk.done(&args("export out --to xlsx -o out.xlsx --units field"));
    assert!(fs::read(desk.path("out.xlsx")).unwrap().starts_with(b"PK"));

    let done = desk.done(&args("export out --to witsml --units field"));
    assert!(text(&done.stderr).contains("each log has one row"), "{}", transcript(&done));
    let xml = desk.text("out/results.xml");
    assert!(xml.contains("<name>trip out, soft string</name>"), "{xml}");
    let hook_load = desk.summary("out").operations[0].scalars.hook_load_N / 4_448.221_615_260_5;
    let row = xml.split("<data>").nth(1).unwrap().split("</data>").next().unwrap();
    let cells: Vec<f64> = row.split(',').map(|cell| cell.parse().unwrap()).collect();
    // Eight digits.
    assert!((cells[0] - 600.0 / 0.3048).abs() < 1e-4 && (cells[1] / hook_load - 1.0).abs() < 1e-7);
    desk.done(&args("export out --to witsml2 -o two.xml"));
    assert!(desk.text("two.xml").contains("<Mnemonic>TORQUE</Mnemonic>"));
}

#[test]
fn a_plan_against_the_depth_of_the_bit() {
    let desk = Desk::new();
    desk.done(&args("plan slant.toml --set model=soft --quiet -o plan"));
    desk.done(&args("export plan --to witsml"));
    let xml = desk.text("plan/results.xml");
    assert!(xml.contains("soft string, expected friction</name>"), "{xml}");
    assert!(xml.matches("<data>").count() > 20, "{xml}");
    desk.done(&args("export plan --to csv -o tables"));
    assert!(
        desk.text("tables/broomstick.csv").starts_with("model,friction,operation,bit depth (m)")
    );
}

#[test]
fn a_sweep_by_the_depth_of_the_bit() {
    let desk = Desk::new();
    desk.done(&args(
        "sweep slant.toml --set model=soft --vary 'bit_depth=300m,400m,500m' --vary friction=0.2,0.3 --quiet -o sweep",
    ));
    desk.done(&args("export sweep --to witsml"));
    let xml = desk.text("sweep/results.xml");
    // Two frictions of two operations.
    assert_eq!(xml.matches("<log ").count(), 4, "{xml}");
    assert_eq!(xml.matches("<data>").count(), 12);
    let refused = desk.run(&args("export sweep --what survey --to csv"));
    assert_eq!(refused.status.code(), Some(2));
    assert!(text(&refused.stderr).contains("whose cases may differ"), "{}", transcript(&refused));
}

/// Eight digits, three decimals, or every digit, depending on the format.
#[test]
fn a_survey_goes_out_and_comes_back() {
    let desk = Desk::new();
    let case = fs::read_to_string(desk.path("slant.toml")).unwrap();
    let stations = "stations = [[0, 0, 0], [300, 0, 0], [330.1234, 3.125, 359.5], [600, 30.5, 12]]";
    let case = case.replace("stations = [[0, 60, 0], [600, 60, 0]]", stations);
    fs::write(desk.path("bent.toml"), &case).unwrap();
    for (format, name, length_m, degrees) in [
        ("csv", "bent-survey.csv", 1e-4, 1e-6),
        ("text", "bent-survey.txt", 0.0051 * 0.3048, 0.00051),
        ("xlsx", "bent-survey.xlsx", 1e-9, 1e-9),
    ] {
        desk.done(&["export", "bent.toml", "--what", "survey", "--to", format, "--units", "field"]);
        let output = desk.done(&["survey", name, "--units", "si"]);
        let rows = text(&output.stdout);
        let rows: Vec<Vec<f64>> = rows
            .lines()
            .skip(1)
            .map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect())
            .collect();
        let expected =
            [[0.0, 0.0, 0.0], [300.0, 0.0, 0.0], [330.1234, 3.125, 359.5], [600.0, 30.5, 12.0]];
        assert_eq!(rows.len(), expected.len(), "{format}");
        for (row, expected) in rows.iter().zip(expected) {
            // The command prints micrometres.
            assert!((row[0] - expected[0]).abs() < length_m + 1e-6, "{format}: {row:?}");
            assert!((row[1] - expected[1]).abs() < degrees + 1e-6, "{format}: {row:?}");
            let turn = (row[2] - expected[2]).abs();
            assert!(expected[1] == 0.0 || turn < degrees + 1e-6, "{format}: {row:?}");
        }
    }
    desk.done(&args("export bent.toml --what survey --to witsml"));
    assert_eq!(desk.text("bent-survey.xml").matches("<trajectoryStation ").count(), 4);
}

#[test]
fn a_string_as_a_tally() {
    let desk = Desk::new();
    desk.done(&args("export slant.toml --what tally --to csv"));
    let csv = desk.text("slant-tally.csv");
    let head = "component,od (mm),id (mm),length (m),weight (kg/m),";
    assert!(csv.starts_with(head), "{csv}");
    assert!(csv.contains("\npipe,120,80,600,"), "{csv}");
    desk.done(&args("export slant.toml --what tally --to witsml2 --units field"));
    assert!(desk.text("slant-tally.xml").contains("<Len uom=\"ft\">1968.5039</Len>"));
}

/// A tally has the metal of each component, in every format and set of units that tables have, and
/// can be read again: lighter pipe is not refused for its weight.
#[test]
fn a_string_of_aluminium_goes_out_and_comes_back() {
    let desk = Desk::new();
    let text = desk.text("slant.toml");
    let (head, pipe) = text.split_once("component = \"pipe\"").unwrap();
    let metal = "component = \"pipe\"\ndensity = 2800\nyoungs_modulus = \"71 GPa\"\n\
                 shear_modulus = \"26.7 GPa\"";
    fs::write(desk.path("light.toml"), format!("{head}{metal}{pipe}")).unwrap();
    let properties = |case: &str| {
        let folder = format!("{case}-results");
        desk.done(&["run", case, "--set", "model=soft", "-q", "-o", &folder]);
        let summary = desk.summary(&folder);
        let string = summary.settings["string"].as_array().unwrap().clone();
        let numbers = [
            "density_kg_per_m3",
            "youngs_modulus_Pa",
            "shear_modulus_Pa",
            "mass_per_length_kg_per_m",
        ];
        string.iter().map(|part| numbers.map(|key| part[key].as_f64().unwrap())).collect::<Vec<_>>()
    };
    let before = properties("light.toml");
    assert_eq!(before.last().unwrap()[..3], [2800.0, 71e9, 26.7e9]);
    for (units, format) in [("si", "csv"), ("field", "csv"), ("metric", "xlsx")] {
        desk.done(&["export", "light.toml", "--what", "tally", "--to", format, "--units", units]);
        let tally = format!("light-tally.{format}");
        let rest = text.split("[[string]]").next().unwrap();
        let imported = desk.done(&["import", &tally]);
        let imported = String::from_utf8(imported.stdout).unwrap();
        let string = &imported[imported.find("[[string]]").unwrap()..];
        let string = string.split("\n[").map(|part| part.trim_start_matches('['));
        let string: String = string
            .filter(|part| part.starts_with("string]]"))
            .map(|part| format!("[[{part}\n"))
            .collect();
        let after = text.rsplit("[[string]]").next().unwrap();
        let after = after.split_once("\n[").map_or(String::new(), |(_, rest)| format!("[{rest}"));
        let again = format!("again-{units}.toml");
        fs::write(desk.path(&again), format!("{rest}{string}{after}")).unwrap();
        for (one, other) in before.iter().zip(properties(&again)) {
            for (one, other) in one.iter().zip(other) {
                // Display units have factors of nine digits.
                assert!((one - other).abs() <= 5e-8 * one.abs(), "{units}: {one} {other}");
            }
        }
    }
    let witsml = desk.done(&["export", "light.toml", "--what", "tally", "--to", "witsml"]);
    assert!(transcript(&witsml).contains("of other metals than steel are left out"));
}

/// An exported file replaces another one entirely or not at all; a device is written to directly.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_leaves_what_was_there() {
    let desk = Desk::new();
    for arguments in [
        &["export", "slant.toml", "--what", "survey", "--to", "csv", "-o", "/dev/full"][..],
        &["survey", "survey.csv", "-o", "/dev/full"],
    ] {
        let full = desk.run(arguments);
        assert_eq!(full.status.code(), Some(3), "{}", transcript(&full));
        let message = transcript(&full);
        assert!(message.contains("cannot write /dev/full: the disk is full"), "{message}");
    }
    desk.done(&["survey", "survey.csv", "-o", "/dev/null"]);
}

#[test]
fn what_cannot_be_exported_is_said() {
    let desk = Desk::new();
    for (arguments, sentence) in [
        ("export slant.toml --to csv", "choose which of them to export: survey or tally"),
        ("export slant.toml --to csv --what results", "a case file has no results"),
        ("export slant.toml --to text --what tally", "a string is not exported as a text report"),
        ("export nothing.toml --to csv --what survey", "nothing.toml"),
        ("export . --to csv", "holds no results"),
    ] {
        let refused = desk.run(&args(arguments));
        assert_eq!(refused.status.code(), Some(2), "{}", transcript(&refused));
        assert!(text(&refused.stderr).contains(sentence), "{}", transcript(&refused));
    }
}
