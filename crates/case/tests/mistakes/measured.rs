//! Mistakes in the file of measured weights that a plan names.

use wholestring_case::{Case, Report, parse};

use crate::{
    common::{SURVEY, survey_files},
    plan::planned,
    refused, warned,
};

const FILE: &str = "weights.csv";

const SOUND: &str = "Bit depth (m),Pick-up (kN),Rotating (kN),Torque (kN.m),use\n\
                     1500,900,700,4.5,yes\n3000,1300,1000,12,no\n";

/// The example with a plan that names a file with this content.
fn with(table: &str) -> Result<Case, Report> {
    with_changed(table, |case| case)
}

fn with_changed(table: &str, change: impl Fn(String) -> String) -> Result<Case, Report> {
    let mut files = survey_files(SURVEY.as_bytes());
    files.0.insert(FILE.to_owned(), table.as_bytes().to_vec());
    let case = change(planned(&format!("measured = \"{FILE}\"")));
    parse("case.toml", case.as_bytes(), &files, &[])
}

#[test]
fn what_the_file_holds() {
    for (name, table) in [
        ("measured_lacks_unit", SOUND.replace("Pick-up (kN)", "Pick-up")),
        ("measured_unit_of_another_dimension", SOUND.replace("Pick-up (kN)", "Pick-up (m)")),
        ("measured_lacks_depth", SOUND.replace("Bit depth (m)", "Time (s)")),
        (
            "measured_unknown_columns_alone",
            "Bit depth (m),Lifting,Lowering\n1500,900,700\n".to_owned(),
        ),
        ("measured_not_a_number", SOUND.replace("1300", "13o0")),
        ("measured_depth_negative", SOUND.replace("1500", "-1500")),
        ("measured_neither_yes_nor_no", SOUND.replace("yes", "perhaps")),
        ("measured_head_alone", SOUND.lines().next().unwrap_or_default().to_owned()),
        ("measured_empty", String::new()),
    ] {
        refused(name, with(&table));
    }
    let missing = planned("measured = \"none.csv\"");
    refused(
        "measured_missing",
        parse("case.toml", missing.as_bytes(), &survey_files(SURVEY.as_bytes()), &[]),
    );
    let listed = planned("measured = [\"weights.csv\"]");
    refused(
        "measured_as_list",
        parse("case.toml", listed.as_bytes(), &survey_files(SURVEY.as_bytes()), &[]),
    );
}

/// The weights of the same file are still used.
#[test]
fn a_torque_on_bottom_is_left_out_where_nothing_drills() {
    let on_bottom = SOUND.replace("Torque (kN.m)", "Torque on bottom (kN.m)");
    let torques = |case: &Case| {
        let readings = &case.plan.measured.as_ref().expect("readings").readings;
        assert!(readings.iter().any(|row| row.pick_up_N.is_some()));
        readings.iter().filter(|row| row.torque_on_bottom_N_m.is_some()).count()
    };
    assert!(with(&on_bottom).is_ok_and(|case| torques(&case) > 0));
    let trips = |case: String| case.replace("kind = \"drill\"", "kind = \"trip_out\"");
    let tripping = with_changed(&on_bottom, trips);
    assert!(tripping.as_ref().is_ok_and(|case| torques(case) == 0));
    warned("warn_measured_on_bottom_without_drilling", tripping);
}

#[test]
fn a_block_of_which_nothing_is_known_is_told() {
    warned("warn_measured_without_block", with(SOUND));
    let with_block = |case: String| case.replace("[rig]", "[rig]\nblock_weight = \"200 kN\"");
    assert!(with_changed(SOUND, with_block).is_ok_and(|case| case.warnings.is_empty()));
}

/// Unknown columns are reported, not refused; columns that are keys of the case are its changes.
#[test]
fn what_was_measured_is_read_as_a_calibration_reads_it() {
    let table = SOUND.replace("use\n", "use,crew,string.1.length (ft)\n");
    let table = table.replace("yes\n", "yes,A,30\n").replace("no\n", "no,B,40\n");
    let case = with(&table).unwrap_or_else(|report| panic!("{report}"));
    let measured = case.plan.measured.expect("readings");
    assert_eq!(measured.file, FILE);
    let [first, second] = &measured.readings[..] else { panic!("two rows") };
    assert_eq!(
        (first.bit_depth_m, first.pick_up_N, first.torque_N_m),
        (1500.0, Some(9e5), Some(4500.0))
    );
    assert_eq!((first.held_out, second.held_out), (false, true));
    assert_eq!(second.keys, [("string.1.length".to_owned(), "40 ft".to_owned())]);
    assert!(
        measured.notes.iter().any(|note| note == "the column 'crew' is not used"),
        "{measured:?}"
    );
}
