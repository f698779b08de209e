//! Mistakes in `[rock]`, `[bit.face]` and `[bit_test]`.

use crate::{
    common::{change::rows, changed, read},
    refused, warned,
};

/// The example with something else in place of its bit's torque.
fn with_bit(keys: &str) -> String {
    let torque = "torque = \"3.1 kN.m\"                   # at the operation's weight on bit";
    changed(torque, keys)
}

/// The example on solid rock: further keys of `[bit]`, and the tables after it.
fn on_rock(bit: &str, tables: &str) -> String {
    let separated = if bit.is_empty() { "" } else { "\n" };
    with_bit(&format!("law = \"rock\"\n{bit}{separated}{tables}")).replace("rop = ", "# rop = ")
}

const SOUND: &str = "[rock]\nstrength = \"60 MPa\"";

#[test]
fn rocks() {
    let cases = rows(
        r#"
        rock_missing: ``
        rock_without_strength: `[rock]\npressure = "10 MPa"`
        rock_strength_twice: `[rock]\nstrength = "60 MPa"\ncohesion = "15 MPa"`
        rock_strength_in_megapascals_meant: `[rock]\nstrength = 60`
        rock_key_misspelt: `[rock]\nstrenght = "60 MPa"`
        rock_dilates_beyond_its_friction:
            `[rock]\nstrength = "60 MPa"\nfriction_angle = 30\ndilation_angle = 40`
        rock_toughness_is_a_pressure:
            `[rock]\nstrength = "60 MPa"\ntensile_fracture_energy = "80 Pa"`
        rock_snaps:
            `[rock]\nstrength = "60 MPa"\ncrushing_energy = "1 kPa"\ntensile_fracture_energy = "0.1 J/m2"`
        rock_bricks_as_wide_as_the_bit: `[rock]\nstrength = "60 MPa"\nelement_size = "20 cm"`
        rock_of_too_many_bricks: `[rock]\nstrength = "60 MPa"\nelement_size = "0.5 mm"`
        rock_for_weeks: `[rock]\nstrength = "60 MPa"\nelement_size = "1.5 mm"\ndensity_factor = 1`
        rock_as_a_list: `[[rock]]\nstrength = "60 MPa"`
        "#,
    );
    for (name, tables) in cases {
        refused(name, read(&on_rock("", &tables)));
    }
    let heavy = format!("{SOUND}\ndensity_factor = 1e5");
    refused("rock_heavier_than_the_bit", read(&on_rock("", &heavy)));
}

#[test]
fn faces() {
    let kinds = [
        ("rock_under_a_roller_cone", "kind = \"roller cone\""),
        ("rock_under_a_core_bit_without_core", "kind = \"core\""),
    ];
    for (name, bit) in kinds {
        refused(name, read(&on_rock(bit, SOUND)));
    }
    let faces = rows(
        r#"
        face_blades_none: `blades = 0`
        face_rake_too_far: `back_rake = 60`
        face_chamfer_beyond_the_cutter: `chamfer = "10 mm"`
        face_cutters_overlap: `cutters_per_blade = 60`
        face_leaves_a_ring: `cutters_per_blade = 1\nblades = 1`
        face_tracks_uneven: `cutters_per_track = 4`
        face_arcs_that_do_not_meet: `nose_radius = "10 mm"\nshoulder_radius = "20 mm"`
        face_cutters_too_fine: `cutter_diameter = "2 mm"`
        face_nose_beyond_the_gauge: `nose = "150 mm"`
        face_key_misspelt: `backrake = 15`
        "#,
    );
    for (name, face) in faces {
        let tables = format!("[bit.face]\n{face}\n{SOUND}");
        refused(name, read(&on_rock("", &tables)));
    }
    let inserts = rows(
        r#"
        inserts_too_sharp: `insert_shape = "cone"\ntip_radius = "0.1 mm"`
        inserts_closer_than_wide: `pitch = "5 mm"`
        inserts_of_unknown_shape: `insert_shape = "chisel"`
        "#,
    );
    for (name, face) in inserts {
        let tables = format!("[bit.face]\n{face}\n{SOUND}");
        refused(name, read(&on_rock("kind = \"inserts\"", &tables)));
    }
    let other = with_bit("law = \"detournay-defourny\"\nkind = \"inserts\"");
    refused("inserts_in_a_law_of_cutters", read(&other));
}

#[test]
fn bit_tests() {
    let cases = [
        ("bit_test_without_rock", "[bit_test]".to_owned()),
        (
            "bit_test_of_a_weight_twice",
            format!("{SOUND}\n[bit_test]\nwob = [\"60 kN\", \"20 kN\", \"60 kN\"]"),
        ),
        ("bit_test_at_rest", format!("{SOUND}\n[bit_test]\nrpm = [0, 60]")),
        ("bit_test_lighter_than_the_bricks", format!("{SOUND}\n[bit_test]\nmass = \"1 kg\"")),
        (
            "bit_test_averages_over_less_than_a_step",
            format!("{SOUND}\n[bit_test]\naveraging = \"0.1 ms\""),
        ),
        ("bit_test_without_weights", format!("{SOUND}\n[bit_test]\nwob = []")),
    ];
    for (name, tables) in cases {
        let tables = format!("torque = \"3.1 kN.m\"\n{tables}");
        refused(name, read(&with_bit(&tables)));
    }
    let off_bottom = changed("kind = \"drill\"", "kind = \"rotate_off_bottom\"")
        .replace("[rig]", &format!("{SOUND}\n[bit_test]\nrpm = 120\n[rig]"));
    refused("bit_test_off_bottom", read(&off_bottom));
}

#[test]
fn what_has_no_effect() {
    let idle = with_bit(&format!("torque = \"3.1 kN.m\"\n[bit.face]\nblades = 5\n{SOUND}"));
    warned("warn_rock_under_another_law", read(&idle));
    let others = on_rock(
        "rock_stiffness = 1e8\nkind = \"inserts\"",
        &format!("[bit.face]\nblades = 5\nhalf_angle = 30\nrows = 11\n{SOUND}"),
    );
    warned("warn_keys_of_other_faces", read(&others));
    let core = on_rock(
        "kind = \"core\"\ncore_diameter = \"4 in\"",
        &format!("[bit.face]\ncone_angle = 10\n{SOUND}"),
    );
    warned("warn_cone_of_a_core_bit", read(&core));
    let strong = on_rock(
        "",
        &format!("{SOUND}\ntensile_strength = \"80 MPa\"\ntensile_fracture_energy = \"20 kJ/m2\""),
    );
    warned("warn_rock_stronger_in_tension_than_its_cone", read(&strong));
    let large = on_rock("", &format!("{SOUND}\nelement_size = \"15 mm\""));
    warned("warn_bricks_large_for_the_cutters", read(&large));
    let heavy = on_rock("", "[rock]\nstrength = \"20 MPa\"").replace("rpm = 70", "rpm = 150");
    warned("warn_rock_too_heavy_for_the_speed", read(&heavy));
    let with_rate = on_rock("", SOUND).replace("# rop = ", "rop = ");
    warned("warn_rate_of_penetration_on_rock", read(&with_rate));
}

/// A bit test uses face, kind and rock whatever the law.
#[test]
fn a_bit_test_leaves_nothing_idle() {
    let text = with_bit(&format!(
        "torque = \"3.1 kN.m\"\nkind = \"core\"\ncore_diameter = \"4 in\"\n[bit.face]\nblades = 5\n{SOUND}\n[bit_test]"
    ));
    let case = read(&text).unwrap_or_else(|report| panic!("{report}"));
    assert!(case.warnings.is_empty(), "{}", case.warnings);
    assert!(case.bit_test.is_some());
}
