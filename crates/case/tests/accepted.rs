//! Accepted cases, and the models built from them.

mod common;
#[path = "../../core/tests/common/np13.rs"]
mod np13;

use common::{EXAMPLE, changed, read, read_with};
use wholestring::{
    dynamics::{
        BitLaw, CentredStart, ContactLaw, Cutters, DynamicsSettings, HoistControl, Motor, Start,
        StartTension, UntilSteady,
    },
    operation::OperationKind,
    outcome::ModelKind,
    string::{Blades, Component, StringSpec},
    well::{Interpolation, Roughness},
};

/// A plan of three corners runs on the curve by which it was computed: a quarter of a circle of
/// 1200/π m, so that the well ends at `600 + 1200/π` m; every shipped case names its curve.
#[test]
fn minimum_curvature_is_the_default() {
    let stations = "stations = [[0, 0, 30], [600, 0, 30], [1200, 90, 30], [4305, 90, 30]]";
    let text = changed("survey = \"np13-x1042-survey.csv\"", stations);
    let case =
        read(&text.replace("path = \"spline\"", "#")).unwrap_or_else(|report| panic!("{report}"));
    assert_eq!(case.model.well.path.interpolation(), Interpolation::MinimumCurvature);
    let end = case.model.well.path.at(4305.0).position_m.z;
    assert!((end - (600.0 + 1200.0 / std::f64::consts::PI)).abs() < 1e-6, "{end}");
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    for folder in ["cases", "studies", "benchmarks/accuracy"] {
        for entry in std::fs::read_dir(root.join(folder)).expect("a folder") {
            let path = entry.expect("an entry").path();
            let text = std::fs::read_to_string(&path).unwrap_or_default();
            let has_well = text.lines().any(|line| line.trim() == "[well]");
            if has_well && path.extension().is_some_and(|extension| extension == "toml") {
                assert!(
                    text.lines().any(|line| line.starts_with("path = \"")),
                    "{}",
                    path.display()
                );
            }
        }
    }
}

#[test]
fn the_documented_example_loads() {
    let case = read(EXAMPLE).unwrap_or_else(|report| panic!("{report}"));
    assert_eq!(case.name, "NP13-X1042 at total depth");
    assert_eq!(case.models, [ModelKind::Dynamic]);
    assert!(case.warnings.is_empty(), "{}", case.warnings);
    assert_eq!(case.model.well.path.stations().len(), 7);
    assert!(!case.survey_notes.is_empty());
    assert_eq!(case.model.well.path.interpolation(), Interpolation::Spline);
    assert_eq!(case.model.well.hole.sections().len(), 2);
    assert_eq!(case.model.well.hole.sections()[1].from_md_m, 2986.53);
    assert_eq!(case.model.mud.density_kg_per_m3, 1200.0);
    assert!((case.model.string.length_m() - 4305.0).abs() < 1e-9);
    let [bit, pipe] = case.model.string.components() else { panic!("two components") };
    assert_eq!((bit.id_m, bit.joints), (0.0, None));
    assert!((pipe.od_m - 0.1397).abs() < 1e-9 && pipe.joints.is_some());
    let [drill] = case.operations.as_slice() else { panic!("one operation") };
    assert_eq!(drill.kind, OperationKind::Drill);
    assert!((drill.rotary_speed_rad_per_s - 70.0 * std::f64::consts::PI / 30.0).abs() < 1e-12);
    assert!((drill.weight_on_bit_N - 6000.0 * 9.80665).abs() < 1e-6);
    assert!((drill.rate_of_penetration_m_per_s - 10.0 / 3600.0).abs() < 1e-12);
    assert_eq!(drill.bit_torque_N_m, 3100.0);
    assert_eq!(case.dynamics, DynamicsSettings::default());
    insta::assert_snapshot!(serde_json::to_string_pretty(&case.settings).expect("JSON"));
}

#[test]
fn optional_tables_take_their_defaults() {
    let text = changed(
        "[steel]                               # defaults for the string; any component may override\ndensity = \"7860 kg/m3\"\nyoungs_modulus = \"210 GPa\"\nshear_modulus = \"76.923 GPa\"\n",
        "",
    );
    let case = read(&text).unwrap_or_else(|report| panic!("{report}"));
    assert_eq!(case.settings, read(EXAMPLE).expect("the example").settings);
    let end = EXAMPLE.find("[mesh]").expect("[mesh]");
    let case = read(&EXAMPLE[..end]).unwrap_or_else(|report| panic!("{report}"));
    // A caller of the library gives the time; a case settles until it is steady.
    let steady = DynamicsSettings {
        settle_s: 0.0,
        steady: Some(UntilSteady::default()),
        ..DynamicsSettings::default()
    };
    assert_eq!(case.dynamics, steady);
    assert_eq!(case.settings["dynamics"]["settle_s"], "auto");
}

/// A given time is used unchanged; the word is the default, and the rows that it may need are
/// counted.
#[test]
fn settling_is_a_time_or_as_long_as_it_takes() {
    let settling = |value: &str| {
        let case = read(&changed("settle = \"20 s\"", &format!("settle = {value}")));
        let case = case.unwrap_or_else(|report| panic!("{report}"));
        (case.dynamics.settle_s, case.dynamics.steady, case.dynamics.longest_s())
    };
    assert_eq!(settling("\"1 min\""), (60.0, None, 120.0));
    assert_eq!(settling("0"), (0.0, None, 60.0));
    let until = Some(UntilSteady::default());
    assert_eq!(settling("\"auto\""), (0.0, until, 180.0));
}

#[test]
fn without_a_name_the_file_gives_it() {
    let text = changed("name = \"NP13-X1042 at total depth\"\n", "");
    assert_eq!(read(&text).expect("a case").name, "case");
}

#[test]
fn windows_line_ends_and_byte_order_marks_are_read() {
    let text = format!("\u{feff}{}", EXAMPLE.replace('\n', "\r\n"));
    let case = read(&text).unwrap_or_else(|report| panic!("{report}"));
    assert_eq!(case.settings, read(EXAMPLE).expect("the example").settings);
}

#[test]
fn without_bit_depth_the_bit_is_at_the_last_station() {
    let text = changed("bit_depth = \"4305 m\"", "# bit_depth");
    let case = read(&text).expect("a case");
    assert_eq!(case.operations[0].bit_depth_m, 4290.0);
    assert!((case.model.string.length_m() - 4290.0).abs() < 1e-9);
}

#[test]
fn stations_in_the_case_are_metres_and_degrees() {
    let text = changed(
        "survey = \"np13-x1042-survey.csv\" ",
        "tie_in = { north = 10, tvd = \"100 ft\" }\nstations = [[0, 0, 0], [\"1000 ft\", 30, 45], [4305, 30, 45.0]] ",
    );
    let case = read(&text).unwrap_or_else(|report| panic!("{report}"));
    let stations = case.model.well.path.stations();
    assert!((stations[1].md_m - 304.8).abs() < 1e-9);
    assert!((stations[1].inclination_rad - 30_f64.to_radians()).abs() < 1e-12);
    assert!((stations[2].azimuth_rad - 45_f64.to_radians()).abs() < 1e-12);
    let start = case.model.well.path.at(0.0).position_m;
    assert!((start.x - 10.0).abs() < 1e-9 && start.y == 0.0 && (start.z - 30.48).abs() < 1e-9);
}

#[test]
fn a_survey_that_starts_deep_hangs_from_the_origin() {
    let text =
        changed("survey = \"np13-x1042-survey.csv\" ", "stations = [[1000, 0, 0], [4305, 0, 0]] ");
    let case = read(&text).unwrap_or_else(|report| panic!("{report}"));
    let top = case.model.well.path.at(0.0).position_m;
    assert!(top.norm() < 1e-9, "{top}");
}

#[test]
fn several_models_and_operations_stand_in_lists() {
    let text = changed("model = \"dynamic\"", "model = [\"soft\", \"dynamic\"]")
        .replace("kind = \"drill\"", "kind = [\"trip_out\", \"slide\", \"rotate_off_bottom\"]");
    let case = read(&text).unwrap_or_else(|report| panic!("{report}"));
    assert_eq!(case.models, [ModelKind::Soft, ModelKind::Dynamic]);
    let kinds: Vec<_> = case.operations.iter().map(|operation| operation.kind).collect();
    assert_eq!(
        kinds,
        [OperationKind::TripOut, OperationKind::Slide, OperationKind::RotateOffBottom]
    );
    assert!(case.operations.iter().all(|operation| operation.bit_torque_N_m == 3100.0));
}

#[test]
fn tripping_needs_no_set_points() {
    let text = changed("kind = \"drill\"", "kind = \"trip_in\"");
    let text: String = text
        .lines()
        .filter(|line| {
            !["rpm", "wob", "rop", "trip_speed", "torque"].iter().any(|key| line.starts_with(key))
        })
        .map(|line| format!("{line}\n"))
        .collect();
    let case = read(&text).unwrap_or_else(|report| panic!("{report}"));
    assert!(case.warnings.is_empty(), "{}", case.warnings);
    assert_eq!(case.operations[0].trip_speed_m_per_s, 0.3);
}

#[test]
fn friction_may_have_a_value_at_rest() {
    let text = changed("friction = 0.3\n[[", "friction = { kinetic = 0.2, static = 0.25 }\n[[");
    let case = read(&text).unwrap_or_else(|report| panic!("{report}"));
    let friction = case.model.well.hole.sections()[0].friction;
    assert_eq!((friction.kinetic, friction.at_rest), (0.2, 0.25));
}

/// Around the hole the coefficient may differ; the static one is in the same ratio.
#[test]
fn friction_may_differ_around_the_hole() {
    let table = "friction = { kinetic = 0.2, static = 0.25, around = 0.3 }\n[[";
    let text = changed("friction = 0.3\n[[", table);
    let case = read(&text).unwrap_or_else(|report| panic!("{report}"));
    let sections = case.model.well.hole.sections();
    assert_eq!(sections[0].friction.at_rest, 0.25);
    assert!((sections[0].friction.around - 1.5).abs() < 1e-15);
    assert_eq!(sections[1].friction.around, 1.0);
    // A number in its place keeps the ratios.
    for key in ["friction", "well.hole.0.friction"] {
        let case = read_with(&text, &[&format!("{key}=0.1")]).expect("a case");
        let friction = case.model.well.hole.sections()[0].friction;
        assert_eq!((friction.kinetic, friction.at_rest), (0.1, 0.125));
        assert!((friction.around - 1.5).abs() < 1e-15);
    }
    // A table replaces it as a whole, and without a ratio there is none to keep.
    let case = read_with(&text, &["well.hole.0.friction={ kinetic = 0.1 }"]).expect("a case");
    let friction = case.model.well.hole.sections()[0].friction;
    assert_eq!((friction.at_rest, friction.around), (0.1, 1.0));
    let smooth =
        text.replace("kinetic = 0.2, static = 0.25, around = 0.3", "kinetic = 0, static = 0.25");
    let case = read_with(&smooth, &["friction=0.1"]).expect("a case");
    assert_eq!(case.model.well.hole.sections()[0].friction.at_rest, 0.1);
}

#[test]
fn the_wall_may_be_rough() {
    let text = changed(
        "[mud]",
        "[well.roughness]\nrms = \"1 mm\"\ntortuosity = \"4 mm\"\nshortest_wavelength = 3\nlongest_wavelength = \"40 m\"\nseed = 9\n[mud]",
    )
    .replace("friction = 0.3\n[[", "friction = 0.3\nroughness = 0.2\n[[");
    let case = read(&text).unwrap_or_else(|report| panic!("{report}"));
    assert!(case.warnings.is_empty(), "{}", case.warnings);
    let hole = &case.model.well.hole;
    assert_eq!(
        hole.roughness(),
        Some(&Roughness {
            radius_rms_m: 0.001,
            tortuosity_rms_m: 0.004,
            shortest_m: 3.0,
            longest_m: 40.0,
            seed: 9,
        })
    );
    let shares: Vec<f64> = hole.sections().iter().map(|s| s.roughness).collect();
    assert_eq!(shares, [0.2, 1.0]);
    assert!(read(EXAMPLE).expect("a case").model.well.hole.roughness().is_none());
}

/// Blades are as long as the component by default.
#[test]
fn a_stabiliser_may_have_blades() {
    let with = |keys: &str| {
        let text = changed(
            "# ...\n",
            &format!(
                "[[string]]\ncomponent = \"stabiliser\"\nod = \"165 mm\"\nid = \"71.4 mm\"\nlength = 1.5\n{keys}\n"
            ),
        );
        let case = read(&text).unwrap_or_else(|report| panic!("{report}"));
        // Its name implies blades: without them there is a warning.
        assert_eq!(case.warnings.is_empty(), !keys.is_empty(), "{}", case.warnings);
        case.model.string.components()[1].blades
    };
    assert_eq!(with(""), None);
    assert_eq!(
        with("blade_od = \"212.7 mm\"\nblade_length = \"0.6 m\""),
        Some(Blades { od_m: 0.2127, length_m: 0.6 })
    );
    assert_eq!(with("blade_od = 0.2127").map(|blades| blades.length_m), Some(1.5));
}

#[test]
fn explicit_pipe_may_have_joints_and_mass() {
    let text = changed(
        "catalogue = \"5-1/2 in 21.90 lb/ft S-135\" ",
        "od = \"139.7 mm\"\nid = \"118.6 mm\"\njoint_od = \"177.8 mm\"\njoint_spacing = \"9.6 m\"\nmass_per_length = \"35.8 kg/m\"\nyield_strength = \"931 MPa\"\ndensity = 7850 ",
    );
    let case = read(&text).unwrap_or_else(|report| panic!("{report}"));
    assert!(case.warnings.is_empty(), "{}", case.warnings);
    let pipe = &case.model.string.components()[1];
    assert_eq!(pipe.mass_per_length_kg_per_m, 35.8);
    assert_eq!(pipe.joints.map(|joints| (joints.od_m, joints.spacing_m)), Some((0.1778, 9.6)));
    assert_eq!(pipe.yield_strength_Pa, Some(931e6));
    assert_eq!(pipe.material.density_kg_per_m3, 7850.0);
    assert_eq!(pipe.material.youngs_modulus_Pa, 210e9);
}

/// Plain pipe touches the wall on its own radius, so that closed forms can be met exactly.
#[test]
fn explicit_pipe_without_joints_is_plain() {
    let text = changed(
        "catalogue = \"5-1/2 in 21.90 lb/ft S-135\" ",
        "od = \"139.7 mm\"\nid = \"118.6 mm\" ",
    );
    let case = read(&text).expect("a case");
    let pipe = &case.model.string.components()[1];
    let area_m2 = std::f64::consts::PI / 4.0 * (0.1397_f64.powi(2) - 0.1186_f64.powi(2));
    assert!((pipe.mass_per_length_kg_per_m - 7860.0 * area_m2).abs() < 1e-9);
    assert_eq!(pipe.contact_radius_m(), 0.1397 / 2.0);
}

#[test]
fn the_other_laws_and_controls_are_taken() {
    let text = changed("contact_law = \"hertz\"", "contact_law = \"linear\"\ncontact_stiffness = \"2e8 N/m\"\ncontact_damping_ratio = 0.1 #")
        .replace("[mesh]", "[hoist]\ncontrol = \"block-velocity\"\nblock_velocity = \"-0.1 m/s\"\n[dynamics.damping]\nmass = 0\n[mesh]")
        .replace("seed = 1", "seed = 7")
        .replace("start = \"prepared\"", "start = \"centred\"\nstart_tension = \"cold\"\nstart_ramp = \"0 s\"");
    let case = read(&text).unwrap_or_else(|report| panic!("{report}"));
    assert!(case.warnings.is_empty(), "{}", case.warnings);
    let linear = ContactLaw::Linear { stiffness_N_per_m: 2e8, damping_ratio: 0.1 };
    assert_eq!(case.dynamics.contact_law, linear);
    assert_eq!(case.dynamics.hoist_control, Some(HoistControl::BlockVelocity(-0.1)));
    assert_eq!(case.dynamics.damping.mass_per_s, 0.0);
    let cold = CentredStart { tension: StartTension::Cold, ramp_s: 0.0 };
    assert_eq!((case.dynamics.start, case.dynamics.centred), (Start::Centred, cold));
    assert_eq!(case.dynamics.seed, 7);
}

#[test]
fn the_command_line_sets_what_the_file_does_not() {
    let case = read_with(
        EXAMPLE,
        &[
            "friction=0.1",
            "well.hole.1.friction = 0.2",
            "bit_depth=3000m",
            "rpm=100",
            "wob=60 kN",
            "operation.kind=[\"drill\", \"slide\"]",
            "model=soft",
            "hoist.control=autodriller",
            "hoist.gain=2e-7m/s/N",
            "name=two at once",
            "string.1.catalogue=5 in 19.50 lb/ft G-105",
        ],
    )
    .unwrap_or_else(|report| panic!("{report}"));
    let friction: Vec<f64> =
        case.model.well.hole.sections().iter().map(|section| section.friction.kinetic).collect();
    assert_eq!(friction, [0.1, 0.2]);
    assert_eq!(case.operations.len(), 2);
    assert_eq!(case.operations[0].bit_depth_m, 3000.0);
    assert_eq!(case.operations[0].weight_on_bit_N, 60e3);
    assert!(
        (case.operations[0].rotary_speed_rad_per_s - 100.0 * std::f64::consts::PI / 30.0).abs()
            < 1e-12
    );
    assert_eq!(case.models, [ModelKind::Soft]);
    assert_eq!(case.dynamics.hoist_control, Some(HoistControl::Autodriller));
    assert_eq!(case.dynamics.autodriller.gain_m_per_s_per_N, 2e-7);
    assert_eq!(case.dynamics.autodriller.filter_s, 1.0);
    assert_eq!(case.name, "two at once");
    assert!((case.model.string.components()[1].od_m - 0.127).abs() < 1e-9);
}

/// The later of two settings of the same key counts, as on other command lines.
#[test]
fn the_last_setting_counts() {
    let case = read_with(EXAMPLE, &["friction=0.1", "friction=0.2"]).expect("a case");
    assert_eq!(case.model.well.hole.sections()[0].friction.kinetic, 0.2);
}

/// Rheology and flow rate in field units.
#[test]
fn mud_that_flows() {
    let text = changed(
        "density = \"1.2 sg\"",
        "density = \"10 ppg\"\nrheology = \"bingham\"\nplastic_viscosity = \"25 cP\"\nyield_point = \"15 lbf/100ft2\"",
    )
    .replace("rpm = 70", "flow_rate = \"600 gpm\"\nbit_pressure_drop = \"1000 psi\"\nrpm = 70");
    let case = read(&text).unwrap_or_else(|report| panic!("{report}"));
    let Some(wholestring::mud::Rheology::Bingham { plastic_viscosity_Pa_s, yield_point_Pa }) =
        case.model.mud.rheology
    else {
        panic!("{:?}", case.model.mud);
    };
    assert!((plastic_viscosity_Pa_s / 0.025 - 1.0).abs() < 1e-12);
    assert!((yield_point_Pa / (15.0 * 0.478_802_59) - 1.0).abs() < 1e-7);
    let operation = &case.operations[0];
    assert!((operation.flow_rate_m3_per_s / 0.037_854_12 - 1.0).abs() < 1e-6);
    assert!((operation.bit_pressure_drop_Pa / 6.894_757e6 - 1.0).abs() < 1e-6);
    assert_eq!(case.settings["mud"]["rheology"]["law"], "bingham");
}

/// The string that the engine's tests build is that of the shipped case to the rounding of its
/// millimetres, but for the fifth digit of a bore from the catalogue.
#[test]
fn the_engines_np13_is_the_shipped_one() {
    let file = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/np13-x1042.toml");
    let case = wholestring_case::load(&file, &[]).unwrap_or_else(|report| panic!("{report}"));
    let built = StringSpec { components: np13::components() };
    let built = built.assemble(case.operations[0].bit_depth_m).unwrap();
    let numbers = |component: &Component| {
        let joints = component.joints.map_or([0.0; 2], |joint| [joint.od_m, joint.spacing_m]);
        let steel = component.material;
        let own = [component.length_m, component.od_m, component.mass_per_length_kg_per_m];
        let metal = [steel.density_kg_per_m3, steel.youngs_modulus_Pa, steel.shear_modulus_Pa];
        [&own[..], &joints, &metal].concat()
    };
    let (shipped, built) = (case.model.string.components(), built.components());
    assert_eq!(shipped.len(), built.len());
    for (shipped, built) in shipped.iter().zip(built) {
        assert_eq!(shipped.name, built.name);
        assert!((shipped.id_m - built.id_m).abs() < 1e-5, "{}", shipped.name);
        for (shipped, built) in numbers(shipped).iter().zip(numbers(built)) {
            assert!((shipped - built).abs() <= 1e-12 * built, "{shipped} {built}");
        }
        let none = (None, None, None);
        assert_eq!((shipped.blades, shipped.bend, shipped.eccentricity), none, "{}", shipped.name);
    }
}

fn cutters_of(keys: &str) -> Cutters {
    let text = changed("torque = \"3.1 kN.m\"", keys);
    let case = read(&text).unwrap_or_else(|report| panic!("{report}"));
    match case.dynamics.bit.law {
        BitLaw::DetournayDefourny(law) => law.cutters,
        BitLaw::Regenerative(law) => law.cutters,
        other => panic!("{other:?}"),
    }
}

#[test]
fn kinds_of_bits_have_their_own_numbers() {
    let pdc = cutters_of("law = \"detournay-defourny\"");
    assert_eq!((pdc.cutter_inclination, pdc.friction), (0.6, 0.6));
    assert_eq!((pdc.radius_m, pdc.core_radius_m), (0.5 * 0.2159, 0.0));
    assert_eq!(pdc, cutters_of("law = \"regenerative\""));
    let roller = cutters_of("law = \"detournay-defourny\"\nkind = \"roller cone\"");
    assert_eq!((roller.cutter_inclination, roller.friction), (3.0, 0.3));
    let explicit = cutters_of(
        "law = \"detournay-defourny\"\nkind = \"roller cone\"\ncutter_inclination = 2\nfriction = 0.2",
    );
    assert_eq!((explicit.cutter_inclination, explicit.friction), (2.0, 0.2));
    let core = cutters_of("law = \"regenerative\"\nkind = \"core\"\ncore_diameter = \"100 mm\"");
    assert_eq!((core.core_radius_m, core.cutter_inclination), (0.05, 0.6));
}

#[test]
fn a_motor_takes_the_operations_flow() {
    let text = changed(
        "torque = \"3.1 kN.m\"",
        "torque = \"3.1 kN.m\"\n[bit.motor]\ndisplacement = \"12 L\"\nmax_differential_pressure = \"80 bar\"",
    )
    .replace("rpm = 70", "rpm = 70\nflow_rate = \"1800 L/min\"");
    let case = read(&text).unwrap_or_else(|report| panic!("{report}"));
    // The flow turns the motor: it has an effect without a rheology.
    assert!(case.warnings.is_empty(), "{}", case.warnings);
    let Motor::Displacement(motor) = case.dynamics.bit.motor else {
        panic!("{:?}", case.dynamics.bit.motor)
    };
    let close = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-12;
    assert!(close(motor.rated_flow_m3_per_s, 30e-3));
    assert!(close(motor.stall_torque_N_m, 1.5 * 0.8 * 12e-3 * 8e6 / std::f64::consts::TAU));
    // 70 rev/min of the string and 150 of the motor, less the leakage at a quarter of the largest
    // torque.
    let turns = 70.0 + 150.0 * (1.0 - 0.1 * 3100.0 / motor.max_torque_N_m());
    let speed = case.dynamics.bit.drilling_speed_rad_per_s(&case.operations[0]);
    assert!(close(speed * 30.0 / std::f64::consts::PI, turns), "{speed}");
}
