//! Landmark EDM exports.

use std::collections::BTreeMap;

use wholestring_import::{Choices, ImportError, Imported, Input, contents, import};

const MINI: &str = include_str!("samples/own/edm-mini-td.xml");
const WELL: &str = include_str!("samples/own/edm-well.xml");
const WELLENG: &str = include_str!("samples/edm/welleng-edm_geopressure_mini.xml");

fn api() -> Choices {
    Choices::default().unit("edm", "api")
}

fn imported(text: &str, choices: &Choices) -> Result<Imported, ImportError> {
    import(vec![Input::of_bytes("edm.xml", text.as_bytes())], choices)
}

fn refusal(text: &str, choices: &Choices) -> String {
    imported(text, choices).expect_err("refused").to_string()
}

/// The case text with its notes.
fn whole(imported: &Imported) -> String {
    let mut text = imported.text.clone();
    text.push_str("--- notes\n");
    for (_, note) in &imported.notes {
        text.push_str(&format!("{}: {}\n", note.kind(), note.text()));
    }
    text.push_str("--- missing\n");
    for missing in &imported.missing {
        text.push_str(&format!("{missing}\n"));
    }
    text
}

#[test]
fn a_small_export() {
    let found = imported(MINI, &api()).expect("imported");
    insta::assert_snapshot!(whole(&found));
    assert_eq!(found.missing.len(), 1, "{:?}", found.missing);
}

#[test]
fn a_published_export_without_a_path() {
    let found = imported(WELLENG, &api()).expect("imported");
    insta::assert_snapshot!(whole(&found));
}

fn well() -> Choices {
    api().pick("wellbore", "WS-1").pick("case", "8 1/2 in drilling")
}

#[test]
fn a_whole_well() {
    let found = imported(WELL, &well()).expect("imported");
    insta::assert_snapshot!(whole(&found));
    assert_eq!(found.missing, Vec::<String>::new());
    let mut text = found.text.clone();
    if !text.contains("rpm = ") {
        text.push_str("rpm = 60\n");
    }
    let template = wholestring_case::Template::in_memory("edm.toml", &text, BTreeMap::new());
    let case = template.case(&[]).unwrap_or_else(|report| panic!("{report:?}"));
    assert!(case.name.starts_with("WS-1"), "{}", case.name);
}

/// The same numbers in metres and kilograms make the same case in SI.
#[test]
fn sets_of_units() {
    let refused = refusal(MINI, &Choices::default());
    assert!(refused.contains("--unit edm=api"), "{refused}");
    assert!(
        refused.contains("the largest md of CD_DEFINITIVE_SURVEY_STATION is 1700"),
        "{refused}"
    );
    assert!(refused.contains("the largest od_body of CD_ASSEMBLY_COMP is 8.5"), "{refused}");
    let refused = refusal(MINI, &Choices::default().unit("edm", "metric"));
    assert!(refused.contains("expected edm=api or edm=si"), "{refused}");
    // Single units take precedence: metres for feet, here.
    let found = imported(MINI, &api().unit("length", "m")).expect("imported");
    assert!(found.text.contains("to = \"1000 m\""), "{}", found.text);
    assert!(found.text.contains("[1700, 6, 0.5]"), "{}", found.text);
    assert!(refusal(MINI, &api().unit("length", "psi")).contains("expected a unit of length"));
    assert!(refusal(MINI, &api().unit("lenght", "m")).contains("no file uses"));
}

/// A wrong set of units gives impossible values: inches read as millimetres are refused.
#[test]
fn an_implausible_set() {
    let steel =
        MINI.replace("od_connection=\"7\"", "od_connection=\"7\" min_yield_stress=\"930.8\"");
    let refused = refusal(&steel, &api());
    assert!(refused.contains("min_yield_stress 930.8 psi is out of range"), "{refused}");
    assert!(refused.contains("--unit stress=UNIT"), "{refused}");
    let found = imported(&steel, &api().unit("stress", "MPa")).expect("imported");
    assert!(found.text.contains("yield_strength = \"930.8 MPa\""), "{}", found.text);
}

/// Positions stated at stations are compared with those of the path, and turns that no pipe endures
/// are reported with the station's line.
#[test]
fn stations_are_checked_against_their_own_positions_and_by_what_pipe_endures() {
    let notes = |text: &str| -> Vec<String> {
        let found = imported(text, &api()).expect("imported");
        found.notes.iter().map(|(_, note)| note.text().to_owned()).collect()
    };
    let has = |notes: &[String], part: &str| notes.iter().any(|note| note.contains(part));
    let stated = |tvd: &str| {
        let last = "md=\"1700\" inclination=\"6\" azimuth=\"0.5\"";
        let middle = "md=\"1500\" inclination=\"0\" azimuth=\"0\"";
        assert!(MINI.contains(last) && MINI.contains(middle));
        let text = MINI.replace(last, &format!("{last} tvd=\"{tvd}\" offset_north=\"10.46\""));
        text.replace(middle, &format!("{middle} tvd=\"1500\""))
    };
    let agreeing = notes(&stated("1699.63"));
    assert!(has(&agreeing, "agree with those of the file within rounding"), "{agreeing:?}");
    let off = notes(&stated("1600"));
    let warning = "true vertical depth of the file is 99.63 ft less than computed from its angles";
    assert!(has(&off, warning), "{off:?}");
    assert!(!has(&off, "deg/100ft"), "{off:?}");
    let bent = notes(&MINI.replace("inclination=\"6\"", "inclination=\"86\""));
    assert!(has(&bent, "deg/100ft") && has(&bent, "1700 ft"), "{bent:?}");
}

#[test]
fn one_of_several() {
    let refused = refusal(WELL, &api());
    assert!(refused.contains("'WS-1', 'WS-2'; pick one: --pick well=NAME"), "{refused}");
    let refused = refusal(WELL, &api().pick("well", "WS-1"));
    assert!(refused.contains("'WS-1', 'WS-1 T2'; pick one: --pick wellbore=NAME"), "{refused}");
    let refused = refusal(WELL, &api().pick("wellbore", "WS-1"));
    assert!(refused.contains("--pick case=NAME"), "{refused}");
    let refused = refusal(WELL, &api().pick("well", "WS-9"));
    assert!(refused.contains("there is no well 'WS-9'; it holds: 'WS-1', 'WS-2'"), "{refused}");
    // The wellbore has one case, so that no further choice is needed.
    let found = imported(WELL, &api().pick("wellbore", "WS-1 T2")).expect("imported");
    let has_note = |text: &str| found.notes.iter().any(|(_, note)| note.text().contains(text));
    assert!(has_note("case '6 in drilling'"), "{:?}", found.notes);
    assert!(has_note("refers to the hole sections 'HG9'"), "{:?}", found.notes);
    assert!(has_note("refers to the fluid 'FL7'"), "{:?}", found.notes);
    // Its depths are relative to sea level: the path begins at minus the elevation of the datum.
    assert!(has_note("the path begins at -82 ft"), "{:?}", found.notes);
    assert!(found.text.contains("    [\"0 ft\", 0, 0],"), "{}", found.text);
}

/// Ids are local to their well: rows of another well with the same ids are excluded.
#[test]
fn ids_repeat_from_well_to_well() {
    let found = imported(WELL, &well()).expect("imported");
    assert!(!found.text.contains("999"), "{}", found.text);
    assert!(found.text.contains("od = \"8.5 in\""), "{}", found.text);
    // A row without its well, where two wells may own it.
    let lost = WELL.replace(
        "<CD_HOLE_SECT well_id=\"WSWELL0001\" wellbore_id=\"WSWB000001\" hole_sect_group_id=\"HG2\" hole_sect_id=\"HS3\"",
        "<CD_HOLE_SECT hole_sect_group_id=\"HG2\" hole_sect_id=\"HS3\"",
    );
    assert_ne!(lost, WELL);
    let refused = refusal(&lost, &well());
    assert!(refused.contains("does not name its well"), "{refused}");
}

/// The order of rows does not matter.
#[test]
fn rows_in_any_order() {
    let first = imported(MINI, &api()).expect("imported");
    let mut lines: Vec<&str> =
        MINI.lines().filter(|line| line.starts_with("<CD_") || line.starts_with("<WP_")).collect();
    lines.reverse();
    let turned = format!("<export><TOPLEVEL>{}</TOPLEVEL></export>", lines.join("\n"));
    let second = imported(&turned, &api()).expect("imported");
    let keys = |text: &str| -> Vec<String> {
        let lines = text.lines().filter(|line| !line.starts_with('#'));
        lines.map(|line| line.split(" # ").next().unwrap_or("").trim().to_owned()).collect()
    };
    let numbers = |text: &str| {
        keys(text).into_iter().filter(|line| !line.starts_with("stations")).collect::<Vec<_>>()
    };
    assert_eq!(numbers(&first.text), numbers(&second.text));
}

/// Casing strings from the surface, one inside the other: the string meets the innermost.
#[test]
fn nested_casings() {
    let found = imported(WELL, &well()).expect("imported");
    let sections = found.text.matches("[[well.hole]]").count();
    assert_eq!(sections, 2, "{}", found.text);
    assert!(found.text.contains("to = \"6200 ft\""));
    assert!(!found.text.contains("diameter = \"12.415 in\""));
    let liner = WELL.replace("length=\"6200\"", "length=\"4000\"");
    let found = imported(&liner, &well()).expect("imported");
    assert!(found.text.contains("to = \"2200 ft\""), "{}", found.text);
    assert_eq!(found.text.matches("[[well.hole]]").count(), 3);
}

#[test]
fn rows_that_cannot_be() {
    let change = |from: &str, to: &str| {
        let text = MINI.replace(from, to);
        assert_ne!(text, MINI, "{from}");
        refusal(&text, &api())
    };
    assert!(change("md=\"1500\"", "md=\"1,500\"").contains("'1,500' is not a number"));
    assert!(change("md=\"1500\"", "md=\"inf\"").contains("'inf' is not a number"));
    assert!(change("inclination=\"6\"", "inclination=\"600\"").contains("out of range"));
    assert!(change("cof=\"0.2\"", "cof=\"20\"").contains("friction factor 20 is out of range"));
    assert!(
        change("hole_size=\"8.5\" length=\"700\"", "hole_size=\"\" length=\"700\"")
            .contains("diameter of the hole section is missing")
    );
    assert!(change("md=\"1700\"", "md=\"1500\"").contains("two stations at 1500 ft have"));
    assert!(change("id_body=\"4.778\"", "id_body=\"5.778\"").contains("less than the outside one"));
    let refused = change("<export>", "<!DOCTYPE a><export>");
    assert!(refused.contains("DOCTYPE") || refused.contains("DTD"), "{refused}");
    let none = "<export><TOPLEVEL a=\"1\"/></export>";
    assert!(refusal(none, &api()).contains("none of which is a row of Landmark's tables"));
}

/// Missing rows are noted, and the rest is imported.
#[test]
fn rows_that_are_not_there() {
    let change = |from: &str, to: &str| {
        let text = MINI.replace(from, to);
        assert_ne!(text, MINI, "{from}");
        let found = imported(&text, &api()).expect("imported");
        let notes: Vec<String> =
            found.notes.iter().map(|(_, note)| note.text().to_owned()).collect();
        (found, notes.join("\n"))
    };
    let (found, notes) =
        change("assembly_id=\"A1\" hole_sect_group_id", "assembly_id=\"A9\" hole_sect_group_id");
    assert!(notes.contains("refers to the assembly 'A9'"), "{notes}");
    assert!(found.missing.iter().any(|missing| missing.contains("the string")));
    let (_, notes) = change(
        "name=\"As drilled\" def_survey_header_id=\"DH1\"",
        "name=\"As drilled\" def_survey_header_id=\"DH9\"",
    );
    assert!(notes.contains("which the file does not have"), "{notes}");
    assert!(notes.contains("the only one of its wellbore"), "{notes}");
    let (found, notes) = change("od_body=\"8.5\" id_body=\"0\"", "od_body=\"\" id_body=\"\"");
    assert!(found.text.contains("od = \"8.5 in\""), "{}", found.text);
    assert!(found.text.contains("because the bit has no od_body"), "{notes}");
    let (found, _) = change("od_body=\"5.5\"", "od_body=\"5.25\"");
    assert!(!found.text.contains("catalogue ="), "{}", found.text);
    let (_, notes) = change("sect_type_code=\"DP\"", "sect_type_code=\"QQ\"");
    assert!(notes.contains("the code 'QQ'"), "{notes}");
}

#[test]
fn what_a_file_holds() {
    let found = contents(Input::of_bytes("edm.xml", WELL.as_bytes())).expect("contents");
    insta::assert_snapshot!(format!("{}\n{}", found.what, found.lines.join("\n")));
}

/// Its drag chart becomes a file that a plan draws over its own curves; that of another case is
/// excluded.
#[test]
fn the_drag_chart() {
    let found = imported(WELL, &well()).expect("imported");
    let [beside] = &found.beside[..] else { panic!("{:?}", found.beside) };
    assert_eq!(beside.ending, "-overlay.csv");
    insta::assert_snapshot!(beside.text);
    let read = wholestring_tabular::read_readings(beside.text.as_bytes(), "overlay.csv");
    let readings = read.expect("readings").readings;
    assert!(readings.is_sorted_by(|a, b| a.bit_depth_m < b.bit_depth_m));
    let mini = imported(MINI, &api()).expect("imported");
    let first = mini.beside[0].text.lines().nth(1).expect("a row");
    assert_eq!(first, "500,60.2,59.6,59.9,100,2300");
}

/// An export in metres and kilograms is recognised, and its drag chart is in kN.
#[test]
fn the_si_set() {
    let found = imported(MINI, &Choices::default().unit("edm", "si")).expect("imported");
    assert!(found.text.contains("length = \"0.85 m\""), "{}", found.text);
    assert!(found.text.contains("mass_per_length = \"24.4 kg/m\""), "{}", found.text);
    let first = found.beside[0].text.lines().next().expect("a heading");
    assert_eq!(
        first,
        "Bit depth (m),Pick-up (kN),Slack-off (kN),Rotating (kN),Torque (kN.m),Torque on bottom (kN.m)"
    );
    assert!(found.beside[0].text.contains("\n500,60.2,59.6,59.9,0.1,2.3\n"));
}

proptest::proptest! {
    #![proptest_config(proptest::test_runner::Config::with_cases(300))]

    /// Any changed bytes give a case or an error, and no panic.
    #[test]
    fn damaged_bytes(
        changes in proptest::collection::vec((0..MINI.len(), proptest::prelude::any::<u8>()), 1..8),
    ) {
        let mut bytes = MINI.as_bytes().to_vec();
        for (place, byte) in changes {
            bytes[place] = byte;
        }
        let inputs = vec![Input::of_bytes("edm.xml", &bytes)];
        if let Err(error) = import(inputs, &api()) {
            proptest::prop_assert!(!error.to_string().is_empty());
        }
    }

    /// Impossible values in any column.
    #[test]
    fn damaged_values(place in 0..2000_usize, value in "-?[0-9]{0,3}(e[0-9]{1,3})?|NaN|inf|[a-z]{0,5}") {
        let starts: Vec<usize> = MINI.match_indices("=\"").map(|(at, _)| at + 2).collect();
        let start = starts[place % starts.len()];
        let length = MINI[start..].find('"').unwrap_or(0);
        let text = format!("{}{value}{}", &MINI[..start], &MINI[start + length..]);
        if let Err(error) = imported(&text, &api()) {
            proptest::prop_assert!(!error.to_string().is_empty());
        }
    }
}

#[test]
fn an_azimuth_of_more_than_a_turn_is_reduced() {
    let turned = MINI.replace("azimuth=\"0.5\"", "azimuth=\"360.5\"");
    let text = whole(&imported(&turned, &api()).expect("imported"));
    assert!(text.contains("6, 0.5],"), "{text}");
    assert!(text.contains("the azimuth of 1 station, more than 360 deg, is reduced"), "{text}");
}

#[test]
fn values_that_no_string_and_no_casing_has_are_refused() {
    for (from, to, expected) in [
        ("length=\"1699.15\"", "length=\"-699.15\"", "the length -699.15 ft is out of range"),
        (
            "id_casing=\"8.535\"",
            "id_casing=\"9.7\"",
            "9.7 in is out of range; expected less than its od_casing, 9.625 in",
        ),
    ] {
        let message = refusal(&MINI.replace(from, to), &api());
        assert!(message.contains(expected), "{message}");
    }
}

#[test]
fn a_nominal_weight_is_warned_of() {
    let text = MINI.replace("approximate_weight=\"24.4\"", "approximate_weight=\"21.9\"");
    let text = whole(&imported(&text, &api()).expect("imported"));
    let warning = "21.9 lb/ft, is the NOMINAL WEIGHT of '5-1/2 in 21.90 lb/ft S-135'";
    assert!(text.contains(warning), "{text}");
}

#[test]
fn a_drag_chart_that_contradicts_itself_is_warned_of() {
    let chart = MINI.replace("to_hookload=\"120.1\"", "to_hookload=\"100.1\"");
    let chart = chart.replace("to_hookload=\"60.2\"", "to_hookload=\"-999.25\"");
    let found = imported(&chart, &api()).expect("imported");
    let text = whole(&found);
    let warning = "the to_hookload of the drag chart is below its ti_hookload in 1 of 2 rows";
    assert!(text.contains(warning), "{text}");
    assert!(text.contains("1 of the values of the drag chart means no value"), "{text}");
}
