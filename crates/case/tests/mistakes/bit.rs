//! Mistakes in `[bit]`.

use wholestring_case::parse;

use crate::{
    common::{SURVEY, change::rows, changed, read, survey_files},
    each_warned, refused, warned,
};

#[test]
fn law_and_excitation() {
    let cases = rows(
        r#"
        bit_law_unknown: `law = "regenerating"`
        bit_law_not_text: `law = 2`
        blades_none: `law = "regenerative"\nblades = 0`
        blades_halved: `law = "regenerative"\nblades = 4.5`
        specific_energy_zero: `law = "regenerative"\nintrinsic_specific_energy = 0`
        specific_energy_in_pascals: `law = "regenerative"\nintrinsic_specific_energy = 60`
        cutter_inclination_zero: `law = "regenerative"\ncutter_inclination = 0`
        wear_flat_negative: `law = "regenerative"\nwear_flat = -1e-3`
        contact_strength_not_a_number: `law = "regenerative"\ncontact_strength = nan`
        bit_geometry_in_quotes: `law = "regenerative"\nbit_geometry = "flat"`
        bit_friction_above_two: `law = "regenerative"\nfriction = 6`
        motor_speed_negative: `motor_speed = -120`
        bit_kind_unknown: `kind = "tricone"`
        roller_cone_with_blades: `law = "regenerative"\nkind = "roller cone"`
        core_bit_without_core: `law = "detournay-defourny"\nkind = "core"`
        core_as_wide_as_the_bit:
            `law = "detournay-defourny"\nkind = "core"\ncore_diameter = "10 in"`
        cleaning_limit_below_full_contact:
            `law = "detournay-defourny"\nfull_contact_depth = "2 mm"\ncleaning_limit = "1 mm"`
        steerability_in_percent: `steerability = 5`
        motor_without_keys: `[bit.motor]`
        motor_without_flow:
            `[bit.motor]\ndisplacement = "12 L"\nmax_differential_pressure = "80 bar"`
        excitation_as_value: `excitation = true`
        excitation_key_misspelt: `[bit.excitation]\nroughnes = "1 mm"`
        excitation_lobes_zero: `[bit.excitation]\nlobes = 0\namplitude = "1 mm"`
        excitation_amplitude_in_mm_meant: `[bit.excitation]\namplitude = 1`
        excitation_torque_in_percent: `[bit.excitation]\ntorque_fluctuation = 20`
        excitation_waves_zero: `[bit.excitation]\nroughness = "1 mm"\nwaves = 0`
        excitation_by_time_and_angle:
            `[bit.excitation]\nroughness = "1 mm"\nwaves = 8\nfrequency = "20 Hz"`
        "#,
    );
    for (name, keys) in cases {
        refused(name, read(&changed("torque = \"3.1 kN.m\"", &keys)));
    }
    let sliding = changed("kind = \"drill\"", "kind = \"slide\"");
    let regenerative = sliding.replace("torque = \"3.1 kN.m\"", "law = \"regenerative\"");
    refused("slide_without_motor_speed", read(&regenerative));
}

/// The example with mud that flows, and something else in place of its bit's torque.
fn flowing(keys: &str) -> String {
    changed("torque = \"3.1 kN.m\"", keys)
        .replace("rpm = 70", "rpm = 70\nflow_rate = \"1800 L/min\"")
}

#[test]
fn motors() {
    let mistakes = rows(
        r#"
        motor_displacement_in_litres_meant:
            `[bit.motor]\ndisplacement = 12\nmax_differential_pressure = "80 bar"`
        motor_given_twice:
            `motor_speed = 120\n[bit.motor]\ndisplacement = "12 L"\nmax_differential_pressure = "80 bar"`
        motor_stalls_early:
            `[bit.motor]\ndisplacement = "12 L"\nmax_differential_pressure = "80 bar"\nstall_torque = "10 kN.m"`
        "#,
    );
    for (name, keys) in mistakes {
        refused(name, read(&flowing(&keys)));
    }
    let odd = rows(
        r#"
        warn_motor_overloaded:
            `torque = "10.1 kN.m"\n[bit.motor]\ndisplacement = "12 L"\nmax_differential_pressure = "60 bar"`
        warn_motor_stalls:
            `torque = "20 kN.m"\n[bit.motor]\ndisplacement = "12 L"\nmax_differential_pressure = "60 bar"`
        "#,
    );
    for (name, keys) in odd {
        warned(name, read(&flowing(&keys)));
    }
}

const POINTS: &str = "law = \"table\"\n[bit.table]\npoints = ";

/// The file of a table.
fn with_file(table: &str) -> Result<wholestring_case::Case, wholestring_case::Report> {
    let text = changed("torque = \"3.1 kN.m\"", "law = \"table\"\n[bit.table]\nfile = \"bit.csv\"");
    let mut files = survey_files(SURVEY.as_bytes());
    files.0.insert("bit.csv".to_owned(), table.as_bytes().to_vec());
    parse("case.toml", text.as_bytes(), &files, &[])
}

const HEAD: &str = "weight_on_bit_N,rotary_speed_rpm,rate_of_penetration_m_per_h,torque_N_m";

#[test]
fn tables() {
    let cases = [
        ("bit_table_missing", "law = \"table\"".to_owned()),
        ("bit_table_empty", "law = \"table\"\n[bit.table]".to_owned()),
        (
            "bit_table_twice",
            "law = \"table\"\n[bit.table]\nfile = \"bit.csv\"\npoints = [[60e3, 70, 10, 3e3]]"
                .to_owned(),
        ),
        ("bit_table_no_such_file", "law = \"table\"\n[bit.table]\nfile = \"bit.csv\"".to_owned()),
        ("bit_table_short_point", format!("{POINTS}[[60e3, 70, 10]]")),
        ("bit_table_speed_zero", format!("{POINTS}[[60e3, 0, 10, 3e3]]")),
        (
            "bit_table_gap",
            format!("{POINTS}[[40e3, 60, 6, 2e3], [40e3, 90, 9, 2e3], [80e3, 60, 12, 4e3]]"),
        ),
        ("bit_table_point_twice", format!("{POINTS}[[40e3, 60, 6, 2e3], [40e3, 60, 9, 2e3]]")),
        (
            "bit_table_spread_here_and_there",
            format!("{POINTS}[[40e3, 60, 6, 2e3, 100], [80e3, 60, 9, 2e3]]"),
        ),
        (
            "bit_table_below_the_operation",
            format!("{POINTS}[[20e3, 60, 6, 2e3], [40e3, 60, 9, 2e3]]"),
        ),
        (
            "bit_table_spread_twice",
            format!(
                "{POINTS}[[60e3, 70, 10, 3e3, 100]]\n[bit.excitation]\ntorque_fluctuation = 0.1"
            ),
        ),
    ];
    for (name, keys) in cases {
        refused(name, read(&changed("torque = \"3.1 kN.m\"", &keys)));
    }
    let files = [
        ("bit_table_file_empty", "\n".to_owned()),
        (
            "bit_table_file_without_torque",
            "weight_on_bit_N,rotary_speed_rpm,rate_of_penetration_m_per_h\n60e3,70,10\n".to_owned(),
        ),
        ("bit_table_file_column_misspelt", format!("{HEAD},torque_sdt_N_m\n60e3,70,10,3e3,100\n")),
        ("bit_table_file_no_number", format!("{HEAD}\n60e3,70,ten,3e3\n")),
        ("bit_table_file_cell_missing", format!("{HEAD}\n60e3,70,10\n")),
        ("bit_table_file_head_alone", format!("{HEAD}\n")),
        ("bit_table_file_negative", format!("{HEAD}\n60e3,70,-10,3e3\n")),
    ];
    for (name, table) in files {
        refused(name, with_file(&table));
    }
}

/// A file and the same points in the case give the same law; unknown columns are ignored.
#[test]
fn a_file_is_read_as_the_points_that_it_holds() {
    let file = format!(
        "\u{feff}{HEAD},torque_std_N_m,specific_energy_Pa\r\n\
         40e3, 60, 6, 2e3, 200, 1e8\r\n40000,90,9,2100,220,1e8\r\n\r\n\
         80e3,60,12,4e3,300,1e8\r\n80e3,90,18,4.1e3,330,1e8\r\n"
    );
    let read_file = with_file(&file).unwrap_or_else(|report| panic!("{report}"));
    let points = "[[\"40 kN\", 60, 6, 2e3, 200], [40e3, 90, \"9 m/h\", 2100, 220], \
                  [80e3, 60, 12, \"4 kN.m\", 300], [80e3, 90, 18, 4100, 330]]";
    let here = read(&changed("torque = \"3.1 kN.m\"", &format!("{POINTS}{points}")));
    let here = here.unwrap_or_else(|report| panic!("{report}"));
    assert_eq!(read_file.dynamics.bit, here.dynamics.bit);
    assert_eq!(read_file.settings["bit"], here.settings["bit"]);
    // Between the points: 58.84 kN of 40 and 80, 70 rev/min of 60 and 90.
    let drill = &here.operations[0];
    let (w, s) = ((6.0 * 9806.65 - 40e3) / 40e3, 1.0 / 3.0);
    let mix = |a: [f64; 2], b: [f64; 2]| {
        let across = |v: [f64; 2]| v[0] + s * (v[1] - v[0]);
        across(a) + w * (across(b) - across(a))
    };
    let rate = mix([6.0, 9.0], [12.0, 18.0]) / 3600.0;
    assert!((drill.rate_of_penetration_m_per_s / rate - 1.0).abs() < 1e-9);
    let torque = mix([2e3, 2.1e3], [4e3, 4.1e3]);
    assert!((drill.bit_torque_N_m / torque - 1.0).abs() < 1e-9);
}

#[test]
fn what_has_no_effect_or_is_odd() {
    each_warned(
        r#"
        warn_bit_torque: `torque = "3.1 kN.m"` -> `# torque`
        warn_bit_does_not_cut: `torque = "3.1 kN.m"` -> `law = "regenerative"\nwear_flat = "20 mm"`
        warn_regenerative_key: `torque = "3.1 kN.m"`
            -> `torque = "3.1 kN.m"\nblades = 6\nwear_flat = "2 mm"`
        warn_rate_key: `torque = "3.1 kN.m"`
            -> `torque = "3.1 kN.m"\nlaw = "regenerative"\n[bit.excitation]\namplitude = "1 mm"`
        warn_excitation_key: `torque = "3.1 kN.m"`
            -> `torque = "3.1 kN.m"\n[bit.excitation]\nlobes = 4\nfrequency = "20 Hz"`
        warn_keys_of_other_laws: `torque = "3.1 kN.m"`
            -> `torque = "3.1 kN.m"\nkind = "core"\ncore_diameter = "4 in"\ncleaning_limit = "5 mm"\n[bit.table]\nfile = "bit.csv"`
        warn_detournay_choked: `torque = "3.1 kN.m"`
            -> `law = "detournay-defourny"\ncleaning_limit = "5 mm"`
        "#,
    );
}
