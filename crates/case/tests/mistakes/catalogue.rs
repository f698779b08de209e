//! Mistakes in a user's own catalogue.

use wholestring_case::{Case, InMemory, Report, parse};

use crate::{
    common::{EXAMPLE, SURVEY, SURVEY_NAME},
    refused,
};

const PIPE: &str = "[[tubular]]\nname = \"rig 7 pipe\"\nod = \"5 in\"\nid = \"4.276 in\"\n\
     yield_strength = \"135 ksi\"\njoint_od = \"6-5/8 in\"\njoint_id = \"3-1/4 in\"\n\
     joint_length = \"17 in\"\njoint_spacing = \"9.5 m\"\nconnection = \"NC50\"\n";

/// The example with its pipe named `name`, and a catalogue with that file name and content.
fn with(file: &str, content: &[u8], name: &str) -> Result<Case, Report> {
    let mut files = InMemory::default();
    files.0.insert(SURVEY_NAME.to_owned(), SURVEY.as_bytes().to_vec());
    files.0.insert(file.to_owned(), content.to_vec());
    let text = EXAMPLE.replace("5-1/2 in 21.90 lb/ft S-135", name);
    parse("case.toml", format!("catalogue = \"{file}\"\n{text}").as_bytes(), &files, &[])
}

/// Overlapping tool joints have a different spacing.
fn spacing(name: &str) -> &'static str {
    if name == "own_joints_overlap" { "4.8 m" } else { "9.5 m" }
}

#[test]
fn in_toml() {
    for (name, from, to) in [
        ("own_without_name", "name = \"rig 7 pipe\"\n", ""),
        ("own_key_unknown", "od = \"5 in\"", "outside = \"5 in\""),
        ("own_unit_of_another_dimension", "od = \"5 in\"", "od = \"5 lb/ft\""),
        ("own_without_wall", "id = \"4.276 in\"", "id = \"5 in\""),
        ("own_joint_without_length", "joint_length = \"17 in\"\n", ""),
        ("own_joint_without_spacing", "joint_spacing = \"9.5 m\"\n", ""),
        ("own_joint_thin", "joint_od = \"6-5/8 in\"", "joint_od = \"4-7/8 in\""),
        ("own_joint_all_bore", "joint_id = \"3-1/4 in\"", "joint_id = \"7 in\""),
        ("own_joints_overlap", "joint_length = \"17 in\"", "joint_length = \"4.9 m\""),
        ("own_joint_id_alone", "joint_od = \"6-5/8 in\"\n", ""),
    ] {
        let content = PIPE.replacen(from, to, 1).replace("9.5 m", spacing(name));
        refused(name, with("mine.toml", content.as_bytes(), "rig 7 pipe"));
    }
    refused("own_twice", with("mine.toml", format!("{PIPE}{PIPE}").as_bytes(), "rig 7 pipe"));
    refused("own_misspelt", with("mine.toml", PIPE.as_bytes(), "rig 8 pipe"));
    refused("own_empty", with("mine.toml", b" \n", "rig 7 pipe"));
    refused("own_not_text", with("mine.toml", b"\xff\xfe\0", "rig 7 pipe"));
    refused("own_no_toml", with("mine.toml", b"name: rig 7 pipe\n", "rig 7 pipe"));
    let yields = format!("{PIPE}make_up_torque = \"40 kN.m\"\ntorsional_yield = \"30 kN.m\"\n");
    refused("own_made_up_beyond_yield", with("mine.toml", yields.as_bytes(), "rig 7 pipe"));
    let missing = EXAMPLE.replacen("name =", "catalogue = \"nowhere.toml\"\nname =", 1);
    refused("own_missing", crate::common::read(&missing));
}

const LINER: &str = "[[casing]]\nname = \"rig 7 liner\"\nod = \"9-5/8 in\"\nid = \"8.681 in\"\n\
     drift = \"8.525 in\"\nmass_per_length = \"47 lb/ft\"\nyield_strength = \"110 ksi\"\n";

/// The example with its casing named `name`, and a catalogue of that content.
fn cased(content: &str, name: &str) -> Result<Case, Report> {
    let mut files = InMemory::default();
    files.0.insert(SURVEY_NAME.to_owned(), SURVEY.as_bytes().to_vec());
    files.0.insert("mine.toml".to_owned(), content.as_bytes().to_vec());
    let text = EXAMPLE.replace("diameter = \"222.96 mm\"", &format!("casing = \"{name}\""));
    parse("case.toml", format!("catalogue = \"mine.toml\"\n{text}").as_bytes(), &files, &[])
}

#[test]
fn casing() {
    for (name, from, to) in [
        ("own_casing_without_name", "name = \"rig 7 liner\"\n", ""),
        ("own_casing_without_wall", "id = \"8.681 in\"", "id = \"9-5/8 in\""),
        ("own_casing_drift", "drift = \"8.525 in\"", "drift = \"8.7 in\""),
        ("own_casing_key_unknown", "drift = ", "drifts = "),
    ] {
        refused(name, cased(&LINER.replacen(from, to, 1), "rig 7 liner"));
    }
    refused("own_casing_twice", cased(&format!("{LINER}{LINER}"), "rig 7 liner"));
    refused("own_casing_misspelt", cased(LINER, "rig 7 linr"));
}

/// Its inside diameter is the hole's, and its yield strength the casing's; built-in casings are
/// found as well.
#[test]
fn casing_of_ones_own_is_a_hole() {
    let both = format!("{PIPE}{LINER}");
    let case = cased(&both, "RIG 7  liner").unwrap_or_else(|report| panic!("{report}"));
    let section = &case.model.well.hole.sections()[0];
    assert!((section.diameter_m - 8.681 * 0.0254).abs() < 1e-12, "{section:?}");
    let casing = section.casing.expect("a casing");
    assert!((casing.od_m - 9.625 * 0.0254).abs() < 1e-12);
    let yields_Pa = casing.yield_strength_Pa.expect("a yield strength");
    assert!((yields_Pa / 110e3 - 6_894.757_293_168).abs() < 1e-6, "{yields_Pa}");
    let built_in = cased(&both, "13-3/8 in 68 lb/ft L-80").expect("a case");
    assert!(built_in.model.well.hole.sections()[0].diameter_m > section.diameter_m);
}

#[test]
fn in_csv() {
    let head = "name,od (in),id (in),yield_strength (ksi)\n";
    for (name, content) in [
        ("own_csv_header_alone", head.to_owned()),
        ("own_csv_without_a_column", "name,od (in)\nrig 7 pipe,5\n".to_owned()),
        ("own_csv_unit_unknown", format!("{}rig 7 pipe,5,4.276,135\n", head.replace("ksi", "kis"))),
        ("own_csv_cell_not_a_number", format!("{head}rig 7 pipe,five,4.276,135\n")),
        ("own_csv_too_many_cells", format!("{head}rig 7 pipe,5,4.276,135,1\n")),
        ("own_csv_column_twice", "name,od,od\nrig 7 pipe,5,5\n".to_owned()),
        ("own_csv_quote_open", format!("{head}\"rig 7 pipe,5,4.276,135\n")),
    ] {
        refused(name, with("mine.csv", content.as_bytes(), "rig 7 pipe"));
    }
}

/// The same tubular from TOML and from CSV, with its masses, torques and words; capitals and blanks
/// do not matter.
#[test]
fn toml_and_csv_say_the_same() {
    let csv = "Name;od in;id [in];yield_strength (ksi);joint_od in;joint_id in;joint_length in;\
               joint_spacing;connection;source\n\
               \"rig 7  pipe\";5;4.276;135;6-5/8;3-1/4;17;9.5 m;NC50;\"\"\n"
        .replace("Name", "name");
    let [toml, csv] = [("mine.toml", PIPE), ("mine.csv", csv.as_str())].map(|(file, content)| {
        let case = with(file, content.as_bytes(), "Rig 7 PIPE");
        case.unwrap_or_else(|report| panic!("{}", report.render(false)))
    });
    let [toml, csv] = [toml, csv].map(|case| case.string.components.last().cloned());
    assert_eq!(toml, csv);
    let pipe = toml.expect("a pipe");
    let built_in = wholestring::string::catalogue::find("5 in 19.50 lb/ft G-105").expect("there");
    // The same joint, with a slightly smaller spacing.
    let connection = built_in.connection.expect("a connection").strength;
    assert_eq!(pipe.connection, connection);
    assert!((pipe.mass_per_length_kg_per_m - 32.0).abs() < 2.0, "{pipe:?}");
}
