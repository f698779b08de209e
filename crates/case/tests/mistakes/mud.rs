//! Mistakes in `[mud]`.

use crate::{
    common::{changed, read},
    each_refused, each_warned, refused,
};

#[test]
fn density() {
    each_refused(
        r#"
        mud_missing: `[mud]\ndensity = "1.2 sg"\n` -> ``
        density_missing: `density = "1.2 sg"` -> ``
        density_1e308: `"1.2 sg"` -> `1e308`
        density_1e400: `"1.2 sg"` -> `1e400`
        density_nan: `"1.2 sg"` -> `nan`
        density_nan_in_quotes: `"1.2 sg"` -> `"nan sg"`
        density_with_too_many_digits: `"1.2 sg"` -> `99999999999999999999`
        mud_denser_than_steel: `"1.2 sg"` -> `"8 sg"`
        "#,
    );
}

/// Zero stays valid: closed forms need it. No mud has it.
#[test]
fn no_density() {
    each_warned(
        r#"
        mud_without_density: `"1.2 sg"` -> `"0 ppg"`
        "#,
    );
}

#[test]
fn rheology_and_flow() {
    let cases = [
        ("rheology_unknown", "\nrheology = \"binghan\""),
        ("rheology_without_numbers", "\nrheology = \"bingham\""),
        (
            "flow_index_above_one",
            "\nrheology = \"power-law\"\nconsistency_index = \"0.6 Pa.s^n\"\nflow_behaviour_index = 1.4",
        ),
        ("viscosity_in_pascals", "\nrheology = \"newtonian\"\nviscosity = \"20 Pa\""),
    ];
    let flow = changed("rpm = 70", "flow_rate = \"2000 L\"\nrpm = 70");
    refused("flow_rate_in_litres", read(&flow));
    for (name, more) in cases {
        let text = changed("density = \"1.2 sg\"", &format!("density = \"1.2 sg\"{more}"));
        refused(name, read(&text));
    }
    each_warned(
        r#"
        warn_mud_key_of_another_rheology: `density = "1.2 sg"`
            -> `density = "1.2 sg"\nrheology = "newtonian"\nviscosity = "20 cP"\nyield_point = "15 lbf/100ft2"`
        warn_mud_key_without_rheology: `density = "1.2 sg"`
            -> `density = "1.2 sg"\nplastic_viscosity = "25 cP"`
        warn_flow_without_rheology: `rpm = 70`
            -> `flow_rate = "2000 L/min"\nbit_pressure_drop = "80 bar"\nrpm = 70`
        "#,
    );
}

/// Dial readings: too few, together with the numbers that they determine, and one with a large
/// deviation.
#[test]
fn dial_readings() {
    let with = |lines: &str| {
        let rheology = "rheology = \"herschel-bulkley\"";
        read(&changed(
            "density = \"1.2 sg\"",
            &format!("density = \"1.2 sg\"\n{rheology}\n{lines}"),
        ))
    };
    refused("dial_readings_missing", with(""));
    refused("dial_readings_of_two_speeds", with("dial_readings = [[600, 65], [300, 40]]"));
    refused("dial_readings_of_one_number", with("dial_readings = [600, 65]"));
    refused(
        "dial_readings_beside_numbers",
        with("yield_point = \"5 Pa\"\ndial_readings = [[600, 65], [300, 40], [6, 7]]"),
    );
    let off = with("dial_readings = [[600, 65], [300, 40], [200, 51], [100, 21], [6, 7], [3, 6]]");
    let off = off.unwrap_or_else(|report| panic!("{report}")).warnings.to_string();
    assert!(off.contains("the dial readings do not follow a yield-power law"), "{off}");
    let sound =
        with("dial_readings = [[600, 65], [300, 40], [200, 31], [100, 21], [6, 7], [3, 6]]");
    let sound = sound.unwrap_or_else(|report| panic!("{report}"));
    assert!(!sound.warnings.to_string().contains("dial"), "{}", sound.warnings);
    assert!(sound.mud_notes[0].starts_with("yield-power law through 6 dial readings"));
}
