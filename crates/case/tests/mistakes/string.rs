//! Mistakes in `[[string]]` and `[steel]`.

use crate::{
    common::{EXAMPLE, changed, read},
    each_refused, each_warned, refused, texts_refused,
};

#[test]
fn words() {
    each_refused(
        r#"
        catalogue_unknown: `5-1/2 in 21.90 lb/ft S-135` -> `5-1/2 in 29.10 lb/ft S-135`
        to_surface_misspelt: `"to surface"` -> `"to the surface"`
        "#,
    );
}

#[test]
fn sizes_and_lengths() {
    let pipe = "catalogue = \"5-1/2 in 21.90 lb/ft S-135\"";
    let explicit = |keys: &str| {
        let start = EXAMPLE.find(pipe).expect("the pipe");
        let end = start + EXAMPLE[start..].find('\n').expect("a line");
        format!("{}{keys}{}", &EXAMPLE[..start], &EXAMPLE[end..])
    };
    texts_refused([
        ("id_not_below_od", explicit("od = \"139.7 mm\"\nid = \"139.7 mm\"")),
        ("id_missing", explicit("od = \"139.7 mm\"")),
        ("od_missing", explicit("id = \"118.6 mm\"")),
        ("od_beside_catalogue", explicit(&format!("{pipe}\nod = \"5 in\""))),
        ("joint_thinner_than_pipe", explicit(&format!("{pipe}\njoint_od = \"5 in\""))),
        (
            "joint_without_spacing",
            explicit("od = \"139.7 mm\"\nid = \"118.6 mm\"\njoint_od = \"7 in\""),
        ),
        ("joint_wider_than_hole", explicit(&format!("{pipe}\njoint_od = \"9 in\""))),
        ("collar_wider_than_hole", explicit("od = \"8-1/2 in\"\nid = \"3 in\"")),
        ("bend_without_place", explicit(&format!("{pipe}\nbend = \"1.5 deg\""))),
        ("lateral_force_without_place", explicit(&format!("{pipe}\nlateral_force = \"15 kN\""))),
        ("bend_of_a_turn", explicit(&format!("{pipe}\nbend = \"90 deg\"\nbend_at = \"2 m\""))),
        ("eccentricity_of_a_crank", explicit(&format!("{pipe}\neccentricity = \"30 mm\""))),
        (
            "eccentricity_cavity_unknown",
            explicit(&format!("{pipe}\neccentricity = \"2 mm\"\neccentricity_cavity = \"air\"")),
        ),
        ("pipe_heavier_than_solid", explicit(&format!("{pipe}\nmass_per_length = \"358 kg/m\""))),
        ("made_up_beyond_yield", explicit(&format!("{pipe}\nmake_up_torque = \"130 kN.m\""))),
        ("class_unknown", explicit("catalogue = \"5-1/2 in 21.90 lb/ft S-135 class 3\"")),
        ("pipe_floats", explicit(&format!("{pipe}\nmass_per_length = \"3.58 kg/m\""))),
        ("metal_floats", explicit(&format!("{pipe}\ndensity = \"1100 kg/m3\""))),
    ]);
    each_refused(
        r#"
        bend_off_its_component: `length = "0.34 m"`
            -> `length = "0.34 m"\nbend = "1 deg"\nbend_at = "1.9 m"`
        lateral_force_off_its_component: `length = "0.34 m"`
            -> `length = "0.34 m"\nlateral_force = "15 kN"\nlateral_force_at = "1.9 m"`
        lateral_force_at_the_bit: `length = "0.34 m"`
            -> `length = "0.34 m"\nlateral_force = "15 kN"\nlateral_force_at = "0.1 m"`
        bend_at_the_bit: `length = "0.34 m"`
            -> `length = "0.34 m"\nbend = "1 deg"\nbend_at = "0.1 m"`
        bit_wider_than_casing: `od = "215.9 mm"` -> `od = "12-1/4 in"`
        string_longer_than_well: `length = "0.34 m"` -> `length = "5000 m"`
        string_shorter_than_well: `length = "to surface"` -> `length = "4000 m"`
        component_above_to_surface: `[bit]`
            -> `[[string]]\ncomponent = "kelly"\nod = 0.13\nid = 0.08\nlength = 12\n[bit]`
        two_components_to_surface: `length = "0.34 m"` -> `length = "to surface"`
        "#,
    );
}

#[test]
fn blades() {
    let stabiliser = "# ...\n";
    let body =
        "[[string]]\ncomponent = \"stabiliser\"\nod = \"165 mm\"\nid = \"71.4 mm\"\nlength = 1.5\n";
    let cases = [
        ("blade_length_without_gauge", stabiliser, format!("{body}blade_length = \"0.6 m\"\n")),
        ("blades_thinner_than_body", stabiliser, format!("{body}blade_od = \"150 mm\"\n")),
        (
            "blades_longer_than_component",
            stabiliser,
            format!("{body}blade_od = \"210 mm\"\nblade_length = 2\n"),
        ),
        ("blades_wider_than_hole", stabiliser, format!("{body}blade_od = \"220 mm\"\n")),
        (
            "blades_beside_joints",
            "length = \"to surface\"",
            "length = \"to surface\"\nblade_od = \"210 mm\"".to_owned(),
        ),
    ];
    for (name, from, to) in cases {
        refused(name, read(&changed(from, &to)));
    }
}

/// Only a bit below other components is assumed to be solid.
#[test]
fn a_pipe_alone() {
    let start = EXAMPLE.find("[[string]]").expect("the string");
    let end = EXAMPLE.find("[bit]").expect("the bit");
    let pipe = "[[string]]\ncomponent = \"pipe\"\nod = \"5 in\"\nlength = \"to surface\"\n";
    let text = format!("{}{pipe}{}", &EXAMPLE[..start], &EXAMPLE[end..]);
    refused("pipe_alone_without_id", read(&text));
}

#[test]
fn what_has_no_effect_or_is_odd() {
    each_warned(
        r#"
        warn_mass: `catalogue = "5-1/2 in 21.90 lb/ft S-135"`
            -> `catalogue = "5-1/2 in 21.90 lb/ft S-135"\nmass_per_length = "20 kg/m" `
        warn_moduli: `"76.923 GPa"` -> `"27 GPa"`
        warn_lateral_force_keys: `catalogue = "5-1/2 in 21.90 lb/ft S-135"`
            -> `catalogue = "5-1/2 in 21.90 lb/ft S-135"\nlateral_force_at = 2\nlateral_force_toolface = "90 deg" `
        warn_bend_keys: `catalogue = "5-1/2 in 21.90 lb/ft S-135"`
            -> `catalogue = "5-1/2 in 21.90 lb/ft S-135"\nbend_at = 2\nbend_toolface = "90 deg" `
        warn_eccentricity_keys: `catalogue = "5-1/2 in 21.90 lb/ft S-135"`
            -> `catalogue = "5-1/2 in 21.90 lb/ft S-135"\neccentricity_phase = 1\neccentricity_cavity = "mud" `
        warn_joint_mass: `catalogue = "5-1/2 in 21.90 lb/ft S-135"`
            -> `od = 0.1397\nid = 0.1186\njoint_od = 0.1778\njoint_spacing = 9.6 `
        "#,
    );
}

/// Mistaken weights and diameters: the nominal weight of pipe, the shank of a bit, the body of a
/// stabiliser, casings that do not fit into each other.
#[test]
fn weights_and_gauges() {
    each_warned(
        r#"
        warn_nominal_weight: `catalogue = "5-1/2 in 21.90 lb/ft S-135"`
            -> `catalogue = "5-1/2 in 21.90 lb/ft S-135"\nmass_per_length = "21.9 lb/ft"`
        warn_nominal_weight_rounded: `catalogue = "5-1/2 in 21.90 lb/ft S-135"`
            -> `catalogue = "5-1/2 in 21.90 lb/ft S-135"\nmass_per_length = "21.8 lb/ft"`
        warn_nominal_weight_of_diameters: `catalogue = "5-1/2 in 21.90 lb/ft S-135"`
            -> `od = "5-1/2 in"\nid = "4.778 in"\nmass_per_length = "21.9 lb/ft"`
        warn_bit_of_its_shank: `od = "215.9 mm"` -> `od = "6.25 in"`
        warn_named_size: `component = "drill pipe"` -> `component = "5-7/8 in drill pipe"`
        warn_named_size_in_quotes: `component = "drill pipe"` -> `component = '6 5/8" DP'`
        warn_ibs_without_blades: `[[string]]\ncomponent = "drill pipe"`
            -> `[[string]]\ncomponent = "IBS"\nod = "6.5 in"\nid = "2.25 in"\nlength = "5.1 ft"\n[[string]]\ncomponent = "drill pipe"`
        warn_stabiliser_without_blades: `[[string]]\ncomponent = "drill pipe"`
            -> `[[string]]\ncomponent = "NB stab"\nod = "6.5 in"\nid = "2.25 in"\nlength = "5.1 ft"\n[[string]]\ncomponent = "drill pipe"`
        "#,
    );
}

/// Names that give the size of the body, of its worn pipe, of a gauge or of a thread.
#[test]
fn sizes_in_names() {
    let named = |name: &str, catalogue: &str| {
        let text = changed("5-1/2 in 21.90 lb/ft S-135", catalogue);
        read(&text.replace("\"drill pipe\"", &format!("'{name}'"))).expect("a valid case").warnings
    };
    let pipe = "5-1/2 in 21.90 lb/ft S-135";
    for name in ["5-1/2 in drill pipe", "5.5\" DP", "139.7 mm drill pipe", "8-1/2 in hole pipe"] {
        assert!(named(name, pipe).is_empty(), "{name}");
    }
    let worn = "5-1/2 in 21.90 lb/ft S-135 premium";
    assert!(named("5-1/2 in drill pipe", worn).is_empty());
    assert!(!named("5 in drill pipe", worn).is_empty());
}
