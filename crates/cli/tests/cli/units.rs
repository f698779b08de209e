//! Sentences and other texts in the reader's units: pages, terminal and workbook.

use std::{fs, path::Path};

use wholestring::statics::soft;
use wholestring_results::{Check, CheckKind, NamedCheck, PlanSummary, checks_of};
use wholestring_units::UnitSet;

use crate::{calibrate, desk::Desk};

/// Units of SI and of the field that the texts of a run, a plan and a calibration contain.
const SI: [&str; 4] = ["m", "kN", "kN.m", "kN·m"];
const FIELD: [&str; 4] = ["ft", "klbf", "ft-lbf", "ft·lbf"];

/// The text around the first number with this unit; `None` where there is none.
fn with_unit<'a>(text: &'a str, unit: &str) -> Option<&'a str> {
    let pattern = format!(" {unit}");
    text.match_indices(&pattern).find_map(|(place, _)| {
        let after = text[place + pattern.len()..].chars().next();
        let is_unit = text[..place].ends_with(|last: char| last.is_ascii_digit())
            && after.is_none_or(|next| {
                !next.is_alphanumeric() && !"/-·.".contains(next)
                    || next == '.'
                        && !text[place + pattern.len() + 1..].starts_with(char::is_alphanumeric)
            });
        let from = (0..=place.saturating_sub(60)).rev().find(|at| text.is_char_boundary(*at));
        is_unit.then(|| &text[from.unwrap_or(0)..place + pattern.len()])
    })
}

#[track_caller]
fn has_none_of(text: &str, units: &[&str]) {
    let text = text.replace('\u{a0}', " ");
    for unit in units {
        assert_eq!(with_unit(&text, unit), None, "{unit}");
    }
}

/// Text of a page of tables as shown with these units, without its tags.
fn shown(page: &str, units: &str) -> String {
    let parts = page.split("<div class=\"in-units in-").skip(1);
    let own: String = parts.filter(|part| part.starts_with(units)).collect();
    assert!(!own.is_empty(), "{units}");
    let own = own.split("<footer>").next().unwrap_or_default();
    let texts = own.split('<').skip(1).filter_map(|part| part.split_once('>'));
    texts.map(|(_, text)| text).collect::<Vec<_>>().join("\n")
}

#[test]
fn numbers_with_units_are_seen() {
    assert!(with_unit("at 3 m: x", "m").is_some() && with_unit("at 3 m.", "m").is_some());
    assert!(with_unit("7 kN", "kN").is_some() && with_unit("7 kN.m", "kN").is_none());
    assert!(with_unit("3 models at 4 mm and 5 m/h", "m").is_none());
}

/// The sentence in the units of the case is that of the file, and in other units that of a judge
/// with those units, for every check of every shipped case by the soft string.
#[test]
fn sentences_of_shipped_cases_in_all_units() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let mut quantities = 0;
    for ready in wholestring_cases::ALL {
        let case = wholestring_case::load(&folder.join(ready.file_name), &[]).expect(ready.name);
        for operation in &case.operations {
            let Ok(profile) = soft::solve(&case.model, operation, &case.soft) else { continue };
            let checks =
                |units: UnitSet| case.judge(units).soft(&case.model, operation, &profile).checks;
            for check in checks(case.units) {
                let json = serde_json::to_string(&check).expect("JSON");
                let read: Check = serde_json::from_str(&json).expect("a check");
                assert_eq!(read.sentence, read.sentence_in(case.units));
                quantities += usize::from(!read.wording.is_empty());
                for &units in UnitSet::ALL {
                    let is = |other: &Check| other.sentence == read.sentence_in(units);
                    assert!(checks(units).iter().any(is), "{}", read.sentence_in(units));
                }
            }
        }
    }
    assert!(quantities > 100, "{quantities}");
}

/// Every check with a number has it in all units in the page's data.
#[test]
fn a_run_is_told_in_the_reader_s_units() {
    let desk = Desk::new();
    let more = [
        "--set",
        "model=\"soft\"",
        "--set",
        "operation.kind=[\"slide\", \"drill\"]",
        "--set",
        "operation.wob=300 kN",
        "-o",
        "out",
    ];
    let output = desk.done(&[&["run", "slant.toml", "--units", "field"][..], &more].concat());
    let screen = String::from_utf8(output.stdout).unwrap();
    let (_, checks) = screen.split_once("error: ").expect("an error");
    has_none_of(checks, &SI);
    let page = desk.text("out/report.html");
    let (_, json) = page.split_once("id=\"report\">").expect("data");
    let json = json.split("</script>").next().unwrap_or_default();
    let report: wholestring_report::Report = serde_json::from_str(json).unwrap();
    let rows: Vec<_> = report.solved.iter().flat_map(|solved| &solved.checks).collect();
    let [si, metric, field] = [0, 1, 2].map(|set| {
        rows.iter().map(|row| row.sentences[set].as_str()).collect::<Vec<_>>().join("\n")
    });
    has_none_of(&si, &FIELD);
    has_none_of(&field, &SI);
    assert!(with_unit(&si, "kN").is_some() && with_unit(&field, "klbf").is_some(), "{si}");
    assert!(with_unit(&metric, "t").is_some(), "{metric}");
    // The file has the units of the command.
    let summary = serde_json::from_str(&desk.text("out/summary.json")).unwrap();
    for NamedCheck { check, .. } in checks_of(&summary) {
        assert_eq!(check.sentence, check.sentence_in(UnitSet::Field));
    }
}

/// Verdicts, campaign and head of a plan, on the terminal, on the page and in its workbook. Depths
/// of the head are those of the case, not those rounded to whole metres.
#[test]
fn a_plan_is_told_in_the_reader_s_units() {
    let desk = Desk::new();
    let more = [
        "--set",
        "plan.bit_depths=[\"1000 ft\", \"1900 ft\"]",
        "--set",
        "operation.wob=300 kN",
        "--set",
        "plan.fatigue.tensile_strength=900 MPa",
        "-o",
        "out",
    ];
    let output = desk.done(&[&["plan", "slant.toml", "--units", "field"][..], &more].concat());
    let screen = String::from_utf8(output.stdout).unwrap();
    has_none_of(&screen, &SI);
    assert!(screen.contains("bit at 1900 ft"), "{screen}");
    let page = desk.text("out/report.html");
    has_none_of(&shown(&page, "field"), &SI);
    has_none_of(&shown(&page, "si"), &FIELD);
    assert!(shown(&page, "field").contains("from 1000 ft; to 1900 ft"));
    let summary = PlanSummary::read(&desk.path("out/summary.json")).unwrap();
    let errors = summary.checks.iter().filter(|row| {
        row.check.kind == CheckKind::LockUp || row.check.kind == CheckKind::WeightNotAvailable
    });
    assert!(errors.count() > 0, "sentences that are no limit");
    desk.done(&["report", "out", "--units", "si"]);
    has_none_of(&shown(&desk.text("out/report.html"), "field"), &SI);
}

/// Band, notes and warnings of a calibration.
#[test]
fn a_calibration_is_told_in_the_reader_s_units() {
    let desk = calibrate::desk();
    let readings = calibrate::readings(&desk);
    // The slack-off at 450 m is an outlier.
    let mut lines: Vec<String> = readings.lines().map(str::to_owned).collect();
    let mut cells: Vec<&str> = lines[2].split(',').collect();
    cells[2] = "250";
    lines[2] = cells.join(",");
    fs::write(desk.path("read.csv"), lines.join("\n")).unwrap();
    let more = ["--bit-torque", "-o", "out", "--units", "field"];
    let output =
        desk.done(&[&["calibrate", "well.toml", "--data", "read.csv"][..], &more].concat());
    let screen = String::from_utf8(output.stdout).unwrap();
    has_none_of(&screen, &SI);
    assert!(screen.contains("outlier"), "{screen}");
    for units in ["field", "si"] {
        let page = desk.text("out/report.html");
        has_none_of(&shown(&page, "field"), &SI);
        has_none_of(&shown(&page, "si"), &FIELD);
        assert!(
            with_unit(&shown(&page, units), if units == "si" { "kN" } else { "klbf" }).is_some()
        );
        desk.done(&["report", "out", "--units", units]);
    }
}

/// The excitation and the sentences on stability of linear vibration.
#[test]
fn modes_are_told_in_the_reader_s_units() {
    let desk = Desk::new();
    desk.done(&["modes", "slant.toml", "-o", "out"]);
    let page = desk.text("out/report.html");
    let [si, field] = ["si", "field"].map(|units| shown(&page, units));
    has_none_of(&field, &SI);
    has_none_of(&si, &FIELD);
    assert!(si.contains("rotating force of") && field.contains("rotating force of"), "{si}");
}
