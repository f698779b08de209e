//! Mistakes in `[bit]`.

use crate::{
    common::{changed, read},
    each_warned, refused,
};

#[test]
fn law_and_excitation() {
    let cases = [
        ("bit_law_unknown", "law = \"regenerating\""),
        ("bit_law_not_text", "law = 2"),
        ("blades_none", "law = \"regenerative\"\nblades = 0"),
        ("blades_halved", "law = \"regenerative\"\nblades = 4.5"),
        (
            "specific_energy_zero",
            "law = \"regenerative\"\nintrinsic_specific_energy = 0",
        ),
        (
            "specific_energy_in_pascals",
            "law = \"regenerative\"\nintrinsic_specific_energy = 60",
        ),
        (
            "cutter_inclination_zero",
            "law = \"regenerative\"\ncutter_inclination = 0",
        ),
        (
            "wear_flat_negative",
            "law = \"regenerative\"\nwear_flat = -1e-3",
        ),
        (
            "contact_strength_not_a_number",
            "law = \"regenerative\"\ncontact_strength = nan",
        ),
        (
            "bit_geometry_in_quotes",
            "law = \"regenerative\"\nbit_geometry = \"flat\"",
        ),
        (
            "bit_friction_above_two",
            "law = \"regenerative\"\nfriction = 6",
        ),
        ("motor_speed_negative", "motor_speed = -120"),
        ("excitation_as_value", "excitation = true"),
        (
            "excitation_key_misspelt",
            "[bit.excitation]\nroughnes = \"1 mm\"",
        ),
        (
            "excitation_lobes_zero",
            "[bit.excitation]\nlobes = 0\namplitude = \"1 mm\"",
        ),
        (
            "excitation_amplitude_in_mm_meant",
            "[bit.excitation]\namplitude = 1",
        ),
        (
            "excitation_torque_in_percent",
            "[bit.excitation]\ntorque_fluctuation = 20",
        ),
        (
            "excitation_waves_zero",
            "[bit.excitation]\nroughness = \"1 mm\"\nwaves = 0",
        ),
        (
            "excitation_by_time_and_angle",
            "[bit.excitation]\nroughness = \"1 mm\"\nwaves = 8\nfrequency = \"20 Hz\"",
        ),
    ];
    for (name, keys) in cases {
        refused(name, read(&changed("torque = \"3.1 kN.m\"", keys)));
    }
    let sliding = changed("kind = \"drill\"", "kind = \"slide\"");
    let regenerative = sliding.replace("torque = \"3.1 kN.m\"", "law = \"regenerative\"");
    refused("slide_without_motor_speed", read(&regenerative));
}

#[test]
fn what_has_no_effect_or_is_odd() {
    each_warned(&[
        ("warn_bit_torque", "torque = \"3.1 kN.m\"", "# torque"),
        (
            "warn_bit_does_not_cut",
            "torque = \"3.1 kN.m\"",
            "law = \"regenerative\"\nwear_flat = \"20 mm\"",
        ),
        (
            "warn_regenerative_key",
            "torque = \"3.1 kN.m\"",
            "torque = \"3.1 kN.m\"\nblades = 6\nwear_flat = \"2 mm\"",
        ),
        (
            "warn_rate_key",
            "torque = \"3.1 kN.m\"",
            "torque = \"3.1 kN.m\"\nlaw = \"regenerative\"\n[bit.excitation]\namplitude = \"1 mm\"",
        ),
        (
            "warn_excitation_key",
            "torque = \"3.1 kN.m\"",
            "torque = \"3.1 kN.m\"\n[bit.excitation]\nlobes = 4\nfrequency = \"20 Hz\"",
        ),
    ]);
}
