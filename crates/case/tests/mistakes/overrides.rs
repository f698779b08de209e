//! Mistakes in an override of the case.

use crate::{
    common::{EXAMPLE, read_with},
    refused,
};

#[test]
fn key_and_value() {
    let cases = [
        ("set_unknown_key", "operation.bitdepth=300m"),
        ("set_unknown_short_key", "torque=3kN.m"),
        ("set_misspelt_short_key", "bitdepth=300m"),
        ("set_index_out_of_range", "well.hole.2.friction=0.1"),
        ("set_index_of_no_list", "mud.0.density=1"),
        ("set_key_in_a_value", "mud.density.value=1"),
        ("set_wrong_unit", "bit_depth=300kg"),
        ("set_negative_friction", "friction=-0.1"),
        ("set_text_for_number", "friction=high"),
        ("set_unclosed_list", "operation.kind=[\"drill\", \"slide\""),
        ("set_relation", "bit_depth=5000m"),
        ("set_empty_part", "mud..density=1"),
        ("set_frequency_without_unit", "dynamics.damping.mass=0.5"),
    ];
    for (name, setting) in cases {
        refused(name, read_with(EXAMPLE, &[setting]));
    }
}

/// A coefficient that keeps its ratio to the kinetic one and thereby leaves its range is reported
/// with the ratio, because the number that was set is in the range.
#[test]
fn a_ratio_that_leads_out_of_the_range() {
    let table = "well.hole.0.friction={ kinetic = 0.1, around = 0.5 }";
    refused("set_friction_beyond_around", read_with(EXAMPLE, &[table, "friction=0.5"]));
}
