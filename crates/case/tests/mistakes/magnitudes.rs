//! Numbers that are probably mistakes: a missing unit, or a value in another unit.

use wholestring_case::{Report, Severity, load};

use crate::{
    common::{EXAMPLE, changed, read, read_with},
    each_refused, each_warned, refused, warned,
};

#[test]
fn unusual_numbers_name_the_unit_that_would_make_sense() {
    each_warned(
        r#"
        usual_density_of_ppg: `"1.2 sg"` -> `10.8`
        usual_density_of_sg: `"1.2 sg"` -> `1.2`
        usual_density_in_another_unit: `"1.2 sg"` -> `"1.2 ppg"`
        usual_weight_on_bit: `"6 tf"` -> `20`
        usual_bit_torque: `"3.1 kN.m"` -> `3.1`
        usual_top_drive_torque: `"45 kN.m"` -> `45`
        usual_trip_speed: `"0.3 m/s"` -> `5`
        usual_rpm: `rpm = 70` -> `rpm = "70 rad/s"`
        usual_rpm_slow: `rpm = 70` -> `rpm = 7.33`
        usual_friction: `friction = 0.3\n[[` -> `friction = 0.02\n[[`
        usual_length: `"0.34 m"` -> `"34 mm"`
        usual_mass_per_length: `length = "to surface"`
            -> `mass_per_length = 21.9\nlength = "to surface"`
        "#,
    );
}

#[test]
fn numbers_out_of_range_name_it_too() {
    each_refused(
        r#"
        usual_hole_diameter: `"215.9 mm"\nfriction` -> `8.5\nfriction`
        usual_od: `od = "215.9 mm"\nlength` -> `od = 215.9\nlength`
        usual_rop: `"10 m/h"` -> `10`
        usual_modulus: `"210 GPa"` -> `210`
        usual_bit_depth: `"4305 m"                  # default` -> `"4305 km" # default`
        usual_friction_too_large: `friction = 0.3\n[[` -> `friction = 3\n[[`
        "#,
    );
}

/// In a case that is shown in feet a length without a unit may be either.
#[test]
fn numbers_without_unit_in_a_field_case() {
    let text = changed("\"0.34 m\"", "1.1")
        .replace("model = \"dynamic\"", "model = \"dynamic\"\nunits = \"field\"")
        .replace("\"4305 m\"\ndiameter", "4305\ndiameter");
    warned("usual_bare_in_field_units", read(&text));
    let shown_in_si = read(&text.replace("\"field\"", "\"si\"")).expect("a valid case");
    assert!(shown_in_si.warnings.is_empty(), "{}", shown_in_si.warnings);
}

/// The unit that is proposed for a number without a unit gives a weight that a block can have: not
/// 110000 klbf, which are 489 MN.
#[test]
fn a_proposed_unit_gives_a_number_that_can_be() {
    let text = changed("[rig]                                 #", "[rig]\nblock_weight = 110000 #")
        .replace("model = \"dynamic\"", "model = \"dynamic\"\nunits = \"field\"");
    let warnings = read(&text).expect("a valid case").warnings.render(false);
    assert!(warnings.contains("\"110000 lbf\""), "{warnings}");
    assert!(!warnings.contains("110000 klbf"), "{warnings}");
    warned("usual_bare_block_weight", read(&text));
    // In no unit is it as large as block weights are.
    let answer = read_with(&text, &["rig.block_weight=7e-9"]);
    refused("block_weight_of_no_size", answer);
}

/// Foot and inch marks, thousands separators, units with more than one meaning.
#[test]
fn lengths_and_weights_as_they_are_written() {
    each_refused(
        r#"
        inch_mark_in_double_quotes: `"215.9 mm"\nfriction` -> `"8.5""\nfriction`
        inch_mark_without_quotes: `"215.9 mm"\nfriction` -> `8-1/2"  # of the bit\nfriction`
        foot_mark_without_quotes: `"4305 m"                  # default` -> `14124' # default`
        thousands_or_decimals: `"4305 m"                  # default` -> `"4,305 m" # default`
        thousands_without_quotes: `"4305 m"                  # default` -> `14,124 # default`
        ton_of_whom: `"6 tf"` -> `"6 ton"`
        "#,
    );
    let text = changed("\"4305 m\"                  # default", "'14,120 ft' # default");
    let case = read(&text).expect("a valid case");
    assert!(case.warnings.is_empty(), "{}", case.warnings);
}

/// Zero switches something off, and needs no unit.
#[test]
fn zero_is_not_doubted() {
    for (from, to) in
        [("\"1.2 sg\"", "0"), ("friction = 0.3\n[[", "friction = 0\n[["), ("\"3.1 kN.m\"", "0")]
    {
        let case = read(&changed(from, to)).expect("a valid case");
        let doubts = |report: &Report| {
            let mut diagnostics = report.diagnostics.iter();
            diagnostics.any(|one| one.message.contains("unusually"))
        };
        assert!(!doubts(&case.warnings), "{to}: {}", case.warnings);
    }
    let case = read_with(EXAMPLE, &["mud.density=0", "bit.torque=0"]).expect("a valid case");
    assert_eq!(case.model.mud.density_kg_per_m3, 0.0);
}

#[test]
fn casing_is_called_by_its_outside_diameter() {
    each_warned(
        r#"
        casing_outside_diameter: `"222.96 mm"` -> `"9-5/8 in"`
        casing_outside_diameter_in_mm: `"222.96 mm"` -> `"244.5 mm"`
        "#,
    );
    each_refused(
        r#"
        casing_outside_or_inside_diameter: `"222.96 mm"` -> `"7-5/8 in"`
        "#,
    );
    // An 8-1/2 in bit passes the bore of 9-7/8 in casing, and no 8-5/8 in casing.
    let inside = read(&changed("222.96 mm", "8.625 in")).expect("a casing of 9-7/8 in");
    assert!(inside.warnings.is_empty(), "{}", inside.warnings);
    let open = changed("\"215.9 mm\"\nfriction", "\"9-5/8 in\"\nfriction");
    let open = read(&open).expect("an open hole of 9-5/8 in");
    assert!(open.warnings.is_empty(), "{}", open.warnings);
}

#[test]
fn casing_by_its_name() {
    let casing = "diameter = \"222.96 mm\"";
    let case = read(&changed(casing, "casing = \"9-5/8 in 40 lb/ft\"")).expect("a valid case");
    assert!(case.warnings.is_empty(), "{}", case.warnings);
    let diameter_m = case.model.well.hole.sections()[0].diameter_m;
    assert!((diameter_m - 8.835 * 0.0254).abs() < 1e-12, "{diameter_m}");
    each_refused(
        r#"
        casing_unknown: `diameter = "222.96 mm"` -> `casing = "9-5/8 in 41 lb/ft"`
        casing_without_weight: `diameter = "222.96 mm"` -> `casing = "9-5/8"`
        casing_and_diameter: `diameter = "222.96 mm"`
            -> `diameter = "222.96 mm"\ncasing = "9-5/8 in 40 lb/ft"`
        casing_of_open_hole: `diameter = "215.9 mm"\nfriction`
            -> `casing = "9-5/8 in 40 lb/ft"\nfriction`
        casing_too_narrow: `diameter = "222.96 mm"` -> `casing = "7 in 29 lb/ft"`
        casing_or_diameter_missing: `diameter = "222.96 mm"\n` -> ``
        "#,
    );
}

/// A shell removes the quotes of `"9.5 ppg"`, and a number without a unit is ambiguous.
#[test]
fn a_number_on_the_command_line_needs_its_unit() {
    for (name, setting) in [
        ("set_density_without_unit", "mud.density=9.5"),
        ("set_density_without_unit_in_quotes", "mud.density=\"9.5\""),
        ("set_wob_without_unit", "wob=5"),
        ("set_bit_depth_without_unit", "bit_depth=3000"),
        ("set_negative_without_unit", "bit_depth=-3000"),
    ] {
        refused(name, read_with(EXAMPLE, &[setting]));
    }
    for setting in [
        "mud.density=9.5ppg",
        "mud.density=\"9.5 ppg\"",
        "friction=0.25",
        "rpm=80",
        "bit.torque=0",
        "dynamics.seed=3",
        "well.stations=[[0, 0, 45], [322.9, 0, 45], [1075, 65, 45], [4305, 65, 45]]",
    ] {
        if setting.starts_with("well.stations") {
            let text = EXAMPLE.replace("survey = \"np13-x1042-survey.csv\"", "");
            let case = read_with(&text, &[setting]);
            assert!(case.is_ok(), "{setting}: {}", case.unwrap_err());
        } else {
            let case = read_with(EXAMPLE, &[setting]);
            assert!(case.is_ok(), "{setting}: {}", case.unwrap_err());
        }
    }
}

/// Shipped cases are within the usual ranges.
#[test]
fn shipped_cases_are_usual() {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");
    let mut found = 0;
    for folder in ["cases", "studies", "benchmarks/accuracy"] {
        for entry in std::fs::read_dir(format!("{root}/{folder}")).expect("the folder") {
            let path = entry.expect("an entry").path();
            let text = std::fs::read_to_string(&path).unwrap_or_default();
            // A study has no operation.
            if path.extension().is_none_or(|end| end != "toml") || !text.contains("[operation]") {
                continue;
            }
            let case = load(&path, &[]).unwrap_or_else(|report| panic!("{report}"));
            let doubts = case.warnings.diagnostics.iter().filter(|one| {
                one.severity == Severity::Warning
                    && (one.message.contains("unusually")
                        || one.message.contains("outside diameter"))
            });
            assert_eq!(doubts.count(), 0, "{}: {}", path.display(), case.warnings);
            found += 1;
        }
    }
    assert!(found >= 15, "only {found} cases");
}
