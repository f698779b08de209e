//! Mistakes that people make, and the answer that each gets, whole.

mod common;

use common::{EXAMPLE, SURVEY, changed, read, read_with, survey_files};
use wholestring_case::{Case, Report, load, parse};

/// Holds the answer against the one on record. The mistake must be refused.
#[track_caller]
fn refused(name: &str, answer: Result<Case, Report>) {
    let Err(report) = answer else {
        panic!("`{name}` was accepted")
    };
    assert!(report.errors() > 0, "`{name}` is refused without an error");
    on_record(name, &report);
}

/// The same for what is accepted with a warning.
#[track_caller]
fn warned(name: &str, answer: Result<Case, Report>) {
    let case = answer.unwrap_or_else(|report| panic!("`{name}` was refused:\n{report}"));
    assert!(!case.warnings.is_empty(), "`{name}` gets no warning");
    on_record(name, &case.warnings);
}

fn on_record(name: &str, report: &Report) {
    let mut settings = insta::Settings::clone_current();
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.set_snapshot_path("mistakes");
    settings.bind(|| insta::assert_snapshot!(name, report.render(false)));
}

#[test]
fn of_spelling() {
    let cases = [
        ("unit_misspelt", "1.2 sg", "1.2 sgg"),
        ("unit_of_another_dimension", "\"1.2 sg\"", "\"1.2 bar\""),
        ("unit_missing_in_quotes", "\"1.2 sg\"", "\"1200\""),
        ("quantity_not_in_quotes", "\"1.2 sg\"", "1.2 sg"),
        ("quantity_with_decimal_comma", "\"1.2 sg\"", "\"1,2 sg\""),
        ("quantity_without_number", "\"1.2 sg\"", "\"heavy\""),
        ("quantity_empty", "\"1.2 sg\"", "\"\""),
        ("quantity_is_a_list", "\"1.2 sg\"", "[1.2, \"sg\"]"),
        ("quantity_is_true", "\"1.2 sg\"", "true"),
        ("key_misspelt", "friction_law", "friction_lw"),
        (
            "key_misspelt_in_well",
            "path = \"spline\"",
            "curve = \"spline\"\nsurvay = 1",
        ),
        ("key_misspelt_at_top", "name = \"NP13", "nmae = \"NP13"),
        (
            "key_of_another_table",
            "torque = \"3.1 kN.m\"",
            "torque = \"3.1 kN.m\"\nwob = \"6 tf\"",
        ),
        (
            "key_at_top_of_a_table",
            "model = \"dynamic\"",
            "model = \"dynamic\"\nrpm = 70",
        ),
        ("table_misspelt", "[mud]", "[mudd]"),
        ("key_twice", "rpm = 70", "rpm = 70\nrpm = 80"),
        ("table_twice", "[mesh]", "[mud]\ndensity = 1000\n[mesh]"),
        (
            "operation_misspelt",
            "kind = \"drill\"",
            "kind = \"driling\"",
        ),
        (
            "operation_with_hyphen",
            "kind = \"drill\"",
            "kind = [\"drill\", \"trip-out\"]",
        ),
        (
            "operation_unknown",
            "kind = \"drill\"",
            "kind = \"cementing\"",
        ),
        (
            "model_misspelt",
            "model = \"dynamic\"",
            "model = \"dynamics\"",
        ),
        (
            "model_not_built",
            "model = \"dynamic\"",
            "model = [\"soft\", \"stiff\"]",
        ),
        (
            "units_unknown",
            "model = \"dynamic\"",
            "model = \"dynamic\"\nunits = \"imperial\"",
        ),
        (
            "hole_kind_unknown",
            "kind = \"open\"",
            "kind = \"openhole\"",
        ),
        (
            "catalogue_unknown",
            "5-1/2 in 21.90 lb/ft S-135",
            "5-1/2 in 29.10 lb/ft S-135",
        ),
        (
            "to_surface_misspelt",
            "\"to surface\"",
            "\"to the surface\"",
        ),
    ];
    for (name, from, to) in cases {
        refused(name, read(&changed(from, to)));
    }
}

#[test]
fn of_shape() {
    let cases = [
        ("bracket_open", "[mud]", "[mud"),
        ("quote_open", "\"1.2 sg\"", "\"1.2 sg"),
        ("value_missing", "density = \"1.2 sg\"", "density ="),
        (
            "table_as_value",
            "[mud]\ndensity = \"1.2 sg\"",
            "mud = \"1.2 sg\"",
        ),
        (
            "single_hole_brackets",
            "[[well.hole]]\nkind = \"casing\"",
            "[well.hole]\nkind = \"casing\"",
        ),
        ("double_mud_brackets", "[mud]", "[[mud]]"),
        (
            "friction_in_quotes",
            "friction = 0.3\n[[",
            "friction = \"0.3\"\n[[",
        ),
        ("name_not_text", "\"NP13-X1042 at total depth\"", "1042"),
        ("name_empty", "\"NP13-X1042 at total depth\"", "\"\""),
        ("operations_empty", "kind = \"drill\"", "kind = []"),
        (
            "operation_listed_twice",
            "kind = \"drill\"",
            "kind = [\"drill\", \"slide\", \"drill\"]",
        ),
        ("seed_negative", "seed = 1", "seed = -1"),
        ("seed_fractional", "seed = 1", "seed = 1.5"),
        ("start_is_a_number", "start = \"prepared\"", "start = 0"),
        ("mud_missing", "[mud]\ndensity = \"1.2 sg\"\n", ""),
        ("density_missing", "density = \"1.2 sg\"", ""),
        ("wob_missing", "wob = \"6 tf\"", ""),
        (
            "rpm_missing",
            "rpm = 70                              # rev/min\n",
            "",
        ),
        ("rop_missing", "rop = \"10 m/h\"", "# rop = \"10 m/h\""),
        (
            "survey_missing_in_case",
            "survey = \"np13-x1042-survey.csv\"",
            "# no survey",
        ),
    ];
    for (name, from, to) in cases {
        refused(name, read(&changed(from, to)));
    }
    let only_top = &EXAMPLE[..EXAMPLE.find("[well]").expect("[well]")];
    refused("only_a_name", read(only_top));
}

#[test]
fn of_magnitude() {
    let cases = [
        (
            "diameter_in_metres_meant_millimetres",
            "\"222.96 mm\"",
            "222.96",
        ),
        ("diameter_negative", "\"222.96 mm\"", "\"-222.96 mm\""),
        ("density_1e308", "\"1.2 sg\"", "1e308"),
        ("density_1e400", "\"1.2 sg\"", "1e400"),
        ("density_nan", "\"1.2 sg\"", "nan"),
        ("density_nan_in_quotes", "\"1.2 sg\"", "\"nan sg\""),
        (
            "density_with_too_many_digits",
            "\"1.2 sg\"",
            "99999999999999999999",
        ),
        (
            "bit_depth_negative",
            "bit_depth = \"4305 m\"",
            "bit_depth = \"-4305 m\"",
        ),
        ("bit_depth_zero", "bit_depth = \"4305 m\"", "bit_depth = 0"),
        (
            "friction_above_two",
            "friction = 0.3\n[[",
            "friction = 30\n[[",
        ),
        ("rpm_too_large", "rpm = 70 ", "rpm = 70000 "),
        ("rpm_zero_while_drilling", "rpm = 70 ", "rpm = 0 "),
        ("mud_denser_than_steel", "\"1.2 sg\"", "\"8 sg\""),
        ("elements_too_short", "\"3.2 m\"", "\"3.2 mm\""),
        ("rows_without_end", "\"60 s\"", "\"86400 s\""),
        ("window_without_samples", "\"60 s\"", "\"1 ms\""),
        (
            "checkpoints_all_the_time",
            "duration = \"60 s\"",
            "duration = \"60 s\"\ncheckpoint_interval = 0",
        ),
        (
            "checkpoints_by_depth",
            "duration = \"60 s\"",
            "duration = \"60 s\"\ncheckpoint_interval = \"5 m\"",
        ),
    ];
    for (name, from, to) in cases {
        refused(name, read(&changed(from, to)));
    }
}

#[test]
fn of_relation() {
    let pipe = "catalogue = \"5-1/2 in 21.90 lb/ft S-135\"";
    let explicit = |keys: &str| {
        let start = EXAMPLE.find(pipe).expect("the pipe");
        let end = start + EXAMPLE[start..].find('\n').expect("a line");
        format!("{}{keys}{}", &EXAMPLE[..start], &EXAMPLE[end..])
    };
    let stations = |rows: &str| {
        changed(
            "survey = \"np13-x1042-survey.csv\"      # md, inc, azi; unit row or units in the header; CSV or Excel",
            &format!("stations = {rows}"),
        )
    };
    let cases = [
        (
            "id_not_below_od",
            explicit("od = \"139.7 mm\"\nid = \"139.7 mm\""),
        ),
        ("id_missing", explicit("od = \"139.7 mm\"")),
        ("od_missing", explicit("id = \"118.6 mm\"")),
        (
            "od_beside_catalogue",
            explicit(&format!("{pipe}\nod = \"5 in\"")),
        ),
        (
            "joint_thinner_than_pipe",
            explicit(&format!("{pipe}\njoint_od = \"5 in\"")),
        ),
        (
            "joint_without_spacing",
            explicit("od = \"139.7 mm\"\nid = \"118.6 mm\"\njoint_od = \"7 in\""),
        ),
        (
            "joint_wider_than_hole",
            explicit(&format!("{pipe}\njoint_od = \"9 in\"")),
        ),
        (
            "collar_wider_than_hole",
            explicit("od = \"8-1/2 in\"\nid = \"3 in\""),
        ),
        (
            "bend_without_place",
            explicit(&format!("{pipe}\nbend = \"1.5 deg\"")),
        ),
        (
            "bend_of_a_turn",
            explicit(&format!("{pipe}\nbend = \"90 deg\"\nbend_at = \"2 m\"")),
        ),
        (
            "bend_off_its_component",
            changed(
                "length = \"0.34 m\"",
                "length = \"0.34 m\"\nbend = \"1 deg\"\nbend_at = \"1.9 m\"",
            ),
        ),
        (
            "bend_at_the_bit",
            changed(
                "length = \"0.34 m\"",
                "length = \"0.34 m\"\nbend = \"1 deg\"\nbend_at = \"0.1 m\"",
            ),
        ),
        (
            "eccentricity_of_a_crank",
            explicit(&format!("{pipe}\neccentricity = \"30 mm\"")),
        ),
        (
            "eccentricity_cavity_unknown",
            explicit(&format!(
                "{pipe}\neccentricity = \"2 mm\"\neccentricity_cavity = \"air\""
            )),
        ),
        (
            "pipe_heavier_than_solid",
            explicit(&format!("{pipe}\nmass_per_length = \"358 kg/m\"")),
        ),
        (
            "pipe_floats",
            explicit(&format!("{pipe}\nmass_per_length = \"3.58 kg/m\"")),
        ),
        (
            "bit_wider_than_casing",
            changed("od = \"215.9 mm\"", "od = \"12-1/4 in\""),
        ),
        (
            "string_longer_than_well",
            changed("length = \"0.34 m\"", "length = \"5000 m\""),
        ),
        (
            "string_shorter_than_well",
            changed("length = \"to surface\"", "length = \"4000 m\""),
        ),
        (
            "component_above_to_surface",
            changed(
                "[bit]",
                "[[string]]\ncomponent = \"kelly\"\nod = 0.13\nid = 0.08\nlength = 12\n[bit]",
            ),
        ),
        (
            "two_components_to_surface",
            changed("length = \"0.34 m\"", "length = \"to surface\""),
        ),
        (
            "hole_short_of_bit",
            changed("to = \"4305 m\"", "to = \"4300 m\""),
        ),
        (
            "hole_sections_not_downwards",
            changed("to = \"4305 m\"", "to = \"2900 m\""),
        ),
        (
            "hole_sections_overlap",
            changed("to = \"4305 m\"", "from = \"2900 m\"\nto = \"4305 m\""),
        ),
        (
            "hole_sections_with_gap",
            changed("to = \"4305 m\"", "from = \"3000 m\"\nto = \"4305 m\""),
        ),
        (
            "static_friction_below_kinetic",
            changed(
                "friction = 0.3\n[[",
                "friction = { kinetic = 0.3, static = 0.2 }\n[[",
            ),
        ),
        (
            "survey_twice",
            changed(
                "path = \"spline\"",
                "stations = [[0, 0, 0], [5000, 0, 0]]\npath = \"spline\"",
            ),
        ),
        (
            "stations_run_backwards",
            stations("[[0, 0, 0], [900, 10, 0], [600, 20, 0], [4305, 20, 0]]"),
        ),
        (
            "station_with_two_numbers",
            stations("[[0, 0, 0], [900, 10], [4305, 20, 0]]"),
        ),
        ("station_alone", stations("[[4305, 0, 0]]")),
        (
            "station_inclination",
            stations("[[0, 0, 0], [900, 190, 0], [4305, 20, 0]]"),
        ),
        (
            "station_bend",
            stations("[[0, 0, 0], [900, 0, 0], [900.5, 30, 0], [4305, 30, 0]]"),
        ),
        (
            "block_heavier_than_hoist",
            changed(
                "[rig] ",
                "[rig]\nblock_weight = \"50 tf\"\nhoist_capacity = \"40 tf\"\n#",
            ),
        ),
        (
            "hook_load_control_without_load",
            changed("[mesh]", "[hoist]\ncontrol = \"hook-load\"\n[mesh]"),
        ),
        (
            "step_of_nanoseconds",
            changed(
                "duration = \"60 s\"",
                "damping.stiffness = \"10 ms\"\nduration = \"60 s\"",
            )
            .replace("\"3.2 m\"", "\"0.2 m\""),
        ),
        (
            "run_of_weeks",
            changed(
                "duration = \"60 s\"",
                "sample_interval = 1\nduration = \"86400 s\"",
            )
            .replace("\"3.2 m\"", "\"0.2 m\"")
            .replace("bit_depth = \"4305 m\"", "bit_depth = \"19999 m\"")
            .replace("to = \"4305 m\"", "to = \"20000 m\""),
        ),
    ];
    for (name, text) in cases {
        refused(name, read(&text));
    }
}

#[test]
fn several_at_once() {
    let text = changed("\"1.2 sg\"", "\"1.2 sgg\"")
        .replace("friction_law", "friction_lw")
        .replace("to = \"4305 m\"", "to = \"4000 m\"")
        .replace("od = \"215.9 mm\"", "od = \"9 in\"");
    refused("several_at_once", read(&text));
}

/// What is no case file at all is not answered line by line.
#[test]
fn a_hundred_at_most() {
    let keys: String = (0..20_000).map(|i| format!("key_{i} = {i}\n")).collect();
    let report = read(&keys).expect_err("no case");
    assert_eq!(report.diagnostics.len(), 100);
    assert!(report.render(false).ends_with("and 80 more\n"));
}

/// Only a bit below other components is taken to be solid.
#[test]
fn of_a_pipe_alone() {
    let start = EXAMPLE.find("[[string]]").expect("the string");
    let end = EXAMPLE.find("[bit]").expect("the bit");
    let pipe = "[[string]]\ncomponent = \"pipe\"\nod = \"5 in\"\nlength = \"to surface\"\n";
    let text = format!("{}{pipe}{}", &EXAMPLE[..start], &EXAMPLE[end..]);
    refused("pipe_alone_without_id", read(&text));
}

#[test]
fn of_the_file() {
    let files = survey_files(SURVEY.as_bytes());
    let binary = [
        0x89, b'P', b'N', b'G', b'\r', b'\n', 0x1a, b'\n', 0, 0, 0, 13,
    ];
    refused("file_empty", parse("case.toml", b"", &files, &[]));
    refused("file_blank", parse("case.toml", b"\n  \n", &files, &[]));
    refused("file_binary", parse("case.toml", &binary, &files, &[]));
    refused(
        "file_with_zero_bytes",
        parse("case.toml", b"name = \"a\"\0\0", &files, &[]),
    );
    refused(
        "file_not_toml",
        parse("case.toml", b"<case>\n  <well/>\n</case>\n", &files, &[]),
    );
    refused("file_missing", load("no-such-case.toml".as_ref(), &[]));
    refused("file_is_a_folder", load("tests".as_ref(), &[]));
}

#[test]
fn of_the_survey() {
    let cases: [(&str, &[u8]); 11] = [
        (
            "survey_runs_backwards",
            b"MD (m),Inc,Azi\n0,0,0\n900,10,45\n600,20,45\n4305,20,45\n",
        ),
        (
            "survey_inclination",
            b"MD (m),Inc,Azi\n0,0,0\n900,190,45\n4305,20,45\n",
        ),
        (
            "survey_not_a_number",
            b"MD (m),Inc,Azi\n0,0,0\n900,1o,45\n4305,20,45\n",
        ),
        (
            "survey_nan",
            b"MD (m),Inc,Azi\n0,0,0\n900,nan,45\n4305,20,45\n",
        ),
        (
            "survey_lacks_azimuth",
            b"MD (m),Inc,TVD\n0,0,0\n900,10,45\n",
        ),
        (
            "survey_lacks_unit",
            b"Measured Depth,Inclination,Azimuth,TVD\n0,0,0,0\n900,10,45,890\n",
        ),
        (
            "survey_unit_of_another_dimension",
            b"MD (kg),Inc,Azi\n0,0,0\n900,10,45\n",
        ),
        ("survey_of_one_station", b"MD (m),Inc,Azi\n0,0,0\n"),
        ("survey_empty", b""),
        ("survey_not_text", b"\x89PNG\r\n\x1a\n\0\0\0\x0d"),
        (
            "survey_workbook_corrupt",
            b"PK\x03\x04 this was a workbook once",
        ),
    ];
    for (name, survey) in cases {
        refused(
            name,
            parse("case.toml", EXAMPLE.as_bytes(), &survey_files(survey), &[]),
        );
    }
    refused(
        "survey_missing",
        read(&changed("np13-x1042-survey.csv", "np13-survey.csv")),
    );
    refused("survey_bend", {
        let survey = b"MD (m),Inc,Azi\n0,0,0\n900,0,45\n901,30,45\n4305,30,45\n";
        parse("case.toml", EXAMPLE.as_bytes(), &survey_files(survey), &[])
    });
}

#[test]
fn of_an_override() {
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
    ];
    for (name, setting) in cases {
        refused(name, read_with(EXAMPLE, &[setting]));
    }
}

#[test]
fn of_the_bit() {
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
fn of_the_wall_and_what_touches_it() {
    let friction = "friction = 0.3\n[[";
    let stabiliser = "# ...\n";
    let body =
        "[[string]]\ncomponent = \"stabiliser\"\nod = \"165 mm\"\nid = \"71.4 mm\"\nlength = 1.5\n";
    let cases = [
        (
            "friction_around_negative",
            friction,
            "friction = { kinetic = 0.3, around = -0.1 }\n[[".to_owned(),
        ),
        (
            "friction_around_without_axial",
            friction,
            "friction = { kinetic = 0, around = 0.2 }\n[[".to_owned(),
        ),
        (
            "roughness_in_metres_meant_millimetres",
            "[mud]",
            "[well.roughness]\nrms = 2\n[mud]".to_owned(),
        ),
        (
            "roughness_too_steep",
            "[mud]",
            "[well.roughness]\ntortuosity = \"20 cm\"\n[mud]".to_owned(),
        ),
        (
            "roughness_band_upside_down",
            "[mud]",
            "[well.roughness]\nrms = \"1 mm\"\nshortest_wavelength = \"20 m\"\nlongest_wavelength = \"2 m\"\n[mud]".to_owned(),
        ),
        (
            "roughness_key_misspelt",
            "[mud]",
            "[well.roughness]\nrms = \"1 mm\"\nwavelength = \"20 m\"\n[mud]".to_owned(),
        ),
        (
            "precision_unknown",
            "seed = 1",
            "seed = 1\nprecision = \"half\"".to_owned(),
        ),
        (
            "precision_of_short_elements",
            "element_length = \"3.2 m\"\n\n[dynamics]",
            "element_length = \"0.5 m\"\n\n[dynamics]\nprecision = \"single\"".to_owned(),
        ),
        (
            "stribeck_speed_zero",
            "seed = 1",
            "seed = 1\nstribeck_speed = 0".to_owned(),
        ),
        (
            "blade_length_without_gauge",
            stabiliser,
            format!("{body}blade_length = \"0.6 m\"\n"),
        ),
        (
            "blades_thinner_than_body",
            stabiliser,
            format!("{body}blade_od = \"150 mm\"\n"),
        ),
        (
            "blades_longer_than_component",
            stabiliser,
            format!("{body}blade_od = \"210 mm\"\nblade_length = 2\n"),
        ),
        (
            "blades_wider_than_hole",
            stabiliser,
            format!("{body}blade_od = \"220 mm\"\n"),
        ),
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

#[test]
fn of_the_mud() {
    let cases = [
        ("rheology_unknown", "\nrheology = \"binghan\""),
        ("rheology_without_numbers", "\nrheology = \"bingham\""),
        (
            "flow_index_above_one",
            "\nrheology = \"power-law\"\nconsistency_index = \"0.6 Pa.s^n\"\nflow_behaviour_index = 1.4",
        ),
        (
            "viscosity_in_pascals",
            "\nrheology = \"newtonian\"\nviscosity = \"20 Pa\"",
        ),
    ];
    let flow = changed("rpm = 70", "flow_rate = \"2000 L\"\nrpm = 70");
    refused("flow_rate_in_litres", read(&flow));
    for (name, more) in cases {
        let text = changed(
            "density = \"1.2 sg\"",
            &format!("density = \"1.2 sg\"{more}"),
        );
        refused(name, read(&text));
    }
}

#[test]
fn of_precision() {
    let single = changed("seed = 1", "seed = 1\nprecision = \"single\"");
    let sliding = single.replace("kind = \"drill\"", "kind = \"slide\"");
    refused("precision_of_a_sliding_string", read(&sliding));
}

#[test]
fn worth_a_warning() {
    let cases = [
        (
            "warn_stribeck_speed",
            "seed = 1",
            "seed = 1\nstribeck_speed = \"0.2 m/s\"",
        ),
        (
            "warn_section_roughness",
            "friction = 0.3\n[[",
            "friction = 0.3\nroughness = 0\n[[",
        ),
        (
            "warn_roughness_without_amplitude",
            "[mud]",
            "[well.roughness]\nseed = 4\n[mud]",
        ),
        (
            "warn_roughness_closes_in",
            "[mud]",
            "[well.roughness]\nrms = \"9 mm\"\n[mud]",
        ),
        ("warn_bit_torque", "torque = \"3.1 kN.m\"", "# torque"),
        (
            "warn_contact_key",
            "contact_law = \"hertz\" ",
            "contact_law = \"hertz\"\ncontact_stiffness = 1e8 ",
        ),
        (
            "warn_hertz_key",
            "contact_law = \"hertz\" ",
            "contact_law = \"linear\"\nhertz_dissipation = 0.1 ",
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
            "warn_bit_does_not_cut",
            "torque = \"3.1 kN.m\"",
            "law = \"regenerative\"\nwear_flat = \"20 mm\"",
        ),
        (
            "warn_excitation_key",
            "torque = \"3.1 kN.m\"",
            "torque = \"3.1 kN.m\"\n[bit.excitation]\nlobes = 4\nfrequency = \"20 Hz\"",
        ),
        (
            "warn_mud_key_of_another_rheology",
            "density = \"1.2 sg\"",
            "density = \"1.2 sg\"\nrheology = \"newtonian\"\nviscosity = \"20 cP\"\nyield_point = \"15 lbf/100ft2\"",
        ),
        (
            "warn_mud_key_without_rheology",
            "density = \"1.2 sg\"",
            "density = \"1.2 sg\"\nplastic_viscosity = \"25 cP\"",
        ),
        (
            "warn_flow_without_rheology",
            "rpm = 70",
            "flow_rate = \"2000 L/min\"\nbit_pressure_drop = \"80 bar\"\nrpm = 70",
        ),
        ("warn_hoist_key", "[mesh]", "[hoist]\ngain = 1e-7\n[mesh]"),
        ("warn_weight_on_bit", "wob = \"6 tf\"", "wob = \"200 tf\""),
        (
            "warn_mass",
            "catalogue = \"5-1/2 in 21.90 lb/ft S-135\"",
            "catalogue = \"5-1/2 in 21.90 lb/ft S-135\"\nmass_per_length = \"20 kg/m\" ",
        ),
        ("warn_moduli", "\"76.923 GPa\"", "\"27 GPa\""),
        (
            "warn_bend_keys",
            "catalogue = \"5-1/2 in 21.90 lb/ft S-135\"",
            "catalogue = \"5-1/2 in 21.90 lb/ft S-135\"\nbend_at = 2\nbend_toolface = \"90 deg\" ",
        ),
        (
            "warn_eccentricity_keys",
            "catalogue = \"5-1/2 in 21.90 lb/ft S-135\"",
            "catalogue = \"5-1/2 in 21.90 lb/ft S-135\"\neccentricity_phase = 1\neccentricity_cavity = \"mud\" ",
        ),
        (
            "warn_joint_mass",
            "catalogue = \"5-1/2 in 21.90 lb/ft S-135\"",
            "od = 0.1397\nid = 0.1186\njoint_od = 0.1778\njoint_spacing = 9.6 ",
        ),
    ];
    for (name, from, to) in cases {
        warned(name, read(&changed(from, to)));
    }
    warned(
        "warn_projection",
        read(
            &changed("bit_depth = \"4305 m\"", "bit_depth = \"4400 m\"")
                .replace("to = \"4305 m\"", "to = \"4500 m\""),
        ),
    );
}

/// The example with lines of a schedule, and one more change.
fn scheduled(lines: &str) -> String {
    changed("[mesh]", &format!("{lines}\n[mesh]"))
}

const LINE: &str = "[[operation.schedule]]\n";

#[test]
fn of_the_schedule() {
    let cases = [
        (
            "schedule_backwards",
            "at = \"30 s\"\nrpm = 60\n",
            "at = \"20 s\"\nrpm = 70",
        ),
        (
            "schedule_over_a_ramp",
            "at = \"30 s\"\nramp = \"10 s\"\nrpm = 60\n",
            "at = \"35 s\"\nrpm = 70",
        ),
        (
            "schedule_two_at_once",
            "at = \"30 s\"\nwob = \"50 kN\"\n",
            "at = \"30 s\"\nblock_velocity = 0",
        ),
        (
            "schedule_weight_and_speed",
            "at = 0\nrpm = 0\n",
            "at = \"30 s\"\nwob = \"50 kN\"\nblock_velocity = \"0.3 m/s\"",
        ),
        (
            "schedule_of_nothing",
            "at = 0\nrpm = 0\n",
            "at = \"30 s\"\nramp = \"10 s\"",
        ),
        ("schedule_without_time", "at = 0\nrpm = 0\n", "rpm = 60"),
        (
            "schedule_key_misspelt",
            "at = 0\nrpm = 0\n",
            "at = \"30 s\"\nrmp = 60",
        ),
        (
            "schedule_before_time_zero",
            "at = \"-5 s\"\nrpm = 0\n",
            "at = \"30 s\"\nrpm = 60",
        ),
    ];
    for (name, first, second) in cases {
        refused(
            name,
            read(&scheduled(&format!("{LINE}{first}{LINE}{second}"))),
        );
    }
    let plan = format!("{LINE}at = \"30 s\"\nrpm = 60");
    refused(
        "schedule_single_brackets",
        read(&scheduled("[operation.schedule]\nat = 0\nrpm = 0")),
    );
    let several = "kind = [\"drill\", \"ream\"]";
    refused(
        "schedule_of_two_operations",
        read(&scheduled(&plan).replace("kind = \"drill\" ", several)),
    );
    refused(
        "schedule_turns_what_does_not",
        read(&scheduled(&plan).replace("kind = \"drill\" ", "kind = \"trip_in\"")),
    );
    let held = format!("{LINE}at = \"30 s\"\nwob = \"50 kN\"");
    refused(
        "schedule_weight_off_bottom",
        read(&scheduled(&held).replace("kind = \"drill\" ", "kind = \"ream\"")),
    );
    let late = format!("{LINE}at = \"80 s\"\nrpm = 60");
    warned("warn_schedule_too_late", read(&scheduled(&late)));
    let soft = scheduled(&plan).replace("model = \"dynamic\" ", "model = \"soft\"");
    warned("warn_schedule_soft", read(&soft));
    let both = scheduled(&plan).replace("model = \"dynamic\" ", "model = [\"soft\", \"dynamic\"]");
    warned("warn_schedule_soft_too", read(&both));
    let pumps = format!("{LINE}at = \"30 s\"\nflow_rate = 0");
    warned(
        "warn_schedule_flow_without_rheology",
        read(&scheduled(&pumps)),
    );
    // Where a schedule holds a weight, the autodriller's keys have their effect.
    let tuned = format!("{held}\n[hoist]\ngain = 1e-7\nintegral_time = \"60 s\"");
    let case = read(&scheduled(&tuned)).expect("a sound case");
    assert!(case.warnings.is_empty());
    assert_eq!(case.dynamics.autodriller.integral_time_s, 60.0);
}

#[test]
fn of_the_top_side() {
    let drive = |keys: &str| changed("[mesh]", &format!("[top_drive]\n{keys}\n[mesh]"));
    let cases = [
        ("top_drive_control_misspelt", "control = \"soft_torque\""),
        ("top_drive_without_inertia", "control = \"pi\"\ninertia = 0"),
        (
            "top_drive_inertia_in_kg",
            "control = \"pi\"\ninertia = \"2900 kg\"",
        ),
        (
            "top_drive_gain_negative",
            "control = \"pi\"\nproportional = -1",
        ),
        (
            "top_drive_frequency_zero",
            "control = \"soft-torque\"\nfrequency = 0",
        ),
    ];
    for (name, keys) in cases {
        refused(name, read(&drive(keys)));
    }
    let hoist = |keys: &str| changed("[mesh]", &format!("[hoist]\n{keys}\n[mesh]"));
    refused(
        "hoist_speeds_reversed",
        read(&hoist(
            "control = \"autodriller\"\nmin_speed = \"60 m/h\"\nmax_speed = \"10 m/h\"",
        )),
    );
    refused("hoist_mass_negative", read(&hoist("mass = \"-20 t\"")));
    let block = |mass: &str| {
        let hoist = format!("[hoist]\nmass = \"{mass}\"\n[rig]\nblock_weight = \"20 tf\"\n#");
        changed("[rig] ", &hoist)
    };
    warned("warn_two_blocks", read(&block("35 t")));
    let same = read(&block("20.5 t")).expect("a sound case");
    assert!(same.warnings.is_empty(), "{}", same.warnings);
    warned(
        "warn_top_drive_constant",
        read(&drive("inertia = \"2900 kg.m2\"")),
    );
    warned(
        "warn_top_drive_tuned",
        read(&drive(
            "control = \"soft-torque\"\nproportional = \"38 kN.m.s\"",
        )),
    );
}

/// `[records]` with these keys.
fn records(keys: &str) -> String {
    changed("[mesh]", &format!("[records]\n{keys}\n\n[mesh]"))
}

#[test]
fn of_records() {
    for (name, keys) in [
        ("frames_as_a_time", "frames = \"0.1 s\""),
        ("frames_never", "frames = 0"),
        ("frames_faster_than_samples", "frames = \"1 kHz\""),
        (
            "channel_unknown",
            "frames = \"10 Hz\"\nchannels = [\"position\", \"velocities\"]",
        ),
        (
            "channel_twice",
            "frames = \"10 Hz\"\nchannels = [\"force\", \"force\"]",
        ),
        ("channels_empty", "frames = \"10 Hz\"\nchannels = []"),
        ("signal_with_its_unit", "spectra = \"surface_torque_N_m\""),
        (
            "spectrum_segment_longer_than_the_window",
            "spectra = \"twist\"\nspectrum_segment = \"10 min\"",
        ),
        (
            "spectrum_segment_of_few_samples",
            "spectra = \"twist\"\nspectrum_segment = \"0.1 s\"",
        ),
        (
            "node_spectra_without_depth",
            "node_spectra = \"bending_moment\"",
        ),
        (
            "node_signal_misspelt",
            "node_spectra = \"bending_momment\"\nnode_spectra_at = \"4290 m\"",
        ),
        (
            "node_spectra_below_the_bit",
            "node_spectra = \"tension\"\nnode_spectra_at = [\"100 m\", \"9 km\"]",
        ),
        (
            "node_spectra_twice_at_a_depth",
            "node_spectra = \"tension\"\nnode_spectra_at = [\"100 m\", 100]",
        ),
    ] {
        refused(name, read(&records(keys)));
    }
    for (name, keys) in [
        (
            "node_spectra_at_without_signal",
            "node_spectra_at = \"4290 m\"",
        ),
        ("channels_without_frames", "channels = \"force\""),
        (
            "spectrum_segment_without_spectra",
            "spectrum_segment = \"5 s\"",
        ),
    ] {
        warned(name, read(&records(keys)));
    }
}
