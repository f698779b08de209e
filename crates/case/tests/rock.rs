//! The solid rock of a case, as input of the engine.

mod common;

use std::f64::consts::PI;

use common::{changed, read};
use wholestring::{
    dynamics::BitLaw,
    rock::{
        BitShape, DrillingSpec, Rock,
        bit_face::{InsertBit, InsertShape, PdcBit},
    },
};
use wholestring_case::{BitTest, Case};

const OD_M: f64 = 0.2159;

/// The example on a rock of 60 MPa, with more in `[bit]`, `[rock]` and after them.
fn on_rock(bit: &str, rock: &str, tables: &str) -> Case {
    let text = changed(
        "torque = \"3.1 kN.m\" ",
        &format!("law = \"rock\"\n{bit}\n[rock]\n{rock}\n{tables}\n#"),
    )
    .replace("rop = ", "# rop = ");
    let case = read(&text).unwrap_or_else(|report| panic!("{report}"));
    assert!(case.warnings.is_empty(), "{}", case.warnings);
    case
}

fn spec(case: &Case) -> &DrillingSpec {
    case.drilling().expect("solid rock")
}

fn pdc(case: &Case) -> PdcBit {
    match spec(case).bit {
        BitShape::Pdc(bit) => bit,
        BitShape::Insert(_) => panic!("inserts"),
    }
}

fn test(case: &Case) -> &BitTest {
    case.bit_test.as_ref().expect("a bit test")
}

const SOUND: &str = "strength = \"60 MPa\"";

/// The other numbers of the rock follow from the strength; face, elements and block from the
/// diameter of the lowest component.
#[test]
fn a_strength_suffices() {
    let case = on_rock("", SOUND, "");
    let found = spec(&case);
    assert_eq!(found.bit, BitShape::Pdc(PdcBit::for_diameter(OD_M)));
    let rock = Rock::for_drilling(60e6);
    assert!((found.block.rock.ucs_Pa() / 60e6 - 1.0).abs() < 1e-12);
    assert_eq!(found.block.rock.crushing_energy_J_per_m3, rock.crushing_energy_J_per_m3);
    let expected = DrillingSpec::new(rock, found.bit, OD_M / 18.0).expect("a sound bit");
    assert_eq!(found.block.cells, expected.block.cells);
    assert_eq!(found.wall_m, expected.wall_m);
    assert_eq!(found.contact, expected.contact);
    assert_eq!(found.block.numerics, expected.block.numerics);
    assert_eq!(found.block.confinement_Pa, 0.0);
    let BitLaw::Rock(law) = &case.dynamics.bit.law else { panic!("{:?}", case.dynamics.bit.law) };
    assert_eq!(&law.drilling, found);
    // The soft string uses the law's estimate.
    let operation = &case.operations[0];
    let steady = law.steady(operation.weight_on_bit_N, operation.rotary_speed_rad_per_s);
    assert_eq!(operation.bit_torque_N_m, steady.torque_N_m);
}

/// `UCS = 2 c cos φ/(1 − sin φ)`, whichever of the two is given.
#[test]
fn cohesion_or_strength() {
    let by_cohesion = on_rock("", "cohesion = \"15 MPa\"\nfriction_angle = 30", "");
    let rock = spec(&by_cohesion).block.rock;
    assert!((rock.cohesion_Pa / 15e6 - 1.0).abs() < 1e-12);
    let ucs_Pa = 2.0 * 15e6 * 3.0_f64.sqrt();
    assert!((rock.ucs_Pa() / ucs_Pa - 1.0).abs() < 1e-12);
    assert!((rock.youngs_modulus_Pa / (300.0 * ucs_Pa) - 1.0).abs() < 1e-12);
    let by_strength = on_rock("", "strength = \"60 MPa\"\nfriction_angle = 30", "");
    let rock = spec(&by_strength).block.rock;
    assert!((rock.ucs_Pa() / 60e6 - 1.0).abs() < 1e-12);
    assert!((rock.cohesion_Pa / (60e6 / (2.0 * 3.0_f64.sqrt())) - 1.0).abs() < 1e-12);
}

/// A dilation angle that is not given is never above the friction angle.
#[test]
fn a_rock_of_little_friction_dilates_no_more() {
    let case = on_rock("", &format!("{SOUND}\nfriction_angle = 6"), "");
    let rock = spec(&case).block.rock;
    assert_eq!(rock.dilation_angle_rad, rock.friction_angle_rad);
}

#[test]
fn every_number_of_the_rock_arrives() {
    let case = on_rock(
        "",
        "strength = \"50 MPa\"\nfriction_angle = 40\ndilation_angle = 5\nyoungs_modulus = \"20 GPa\"\npoisson_ratio = 0.2\n\
         density = 2700\ntensile_strength = \"4 MPa\"\ntensile_fracture_energy = \"100 J/m2\"\ncrushing_energy = \"4 MJ/m3\"\n\
         compressive_fracture_energy = \"9 kJ/m2\"\npressure = \"10 MPa\"\nconfinement = \"12 MPa\"\nfriction = 0.2\n\
         element_size = \"10 mm\"\ndensity_factor = 50\nbeside = \"41 mm\"\nbelow = \"69 mm\"",
        "",
    );
    let found = spec(&case);
    let rock = found.block.rock;
    let degree = PI / 180.0;
    assert!((rock.friction_angle_rad - 40.0 * degree).abs() < 1e-12);
    assert!((rock.dilation_angle_rad - 5.0 * degree).abs() < 1e-12);
    assert_eq!(rock.youngs_modulus_Pa, 20e9);
    assert_eq!(rock.poisson_ratio, 0.2);
    assert_eq!(rock.density_kg_per_m3, 2700.0);
    assert_eq!(rock.tensile_strength_Pa, 4e6);
    assert_eq!(rock.tensile_fracture_energy_J_per_m2, 100.0);
    assert_eq!(rock.compressive_fracture_energy_J_per_m2, 9e3);
    assert_eq!(rock.crushing_energy_J_per_m3, 4e6);
    let block = &found.block;
    assert_eq!([block.pressure_Pa, block.confinement_Pa], [10e6, 12e6]);
    assert_eq!(found.contact.friction, 0.2);
    assert_eq!(block.size_m, [0.01; 3]);
    assert_eq!(block.numerics.density_factor, 50.0);
    // 215.9 mm and 41 mm on each side; the stored part of the wall, the layer of the nose, and 69
    // mm.
    let wall = (found.wall_m / 0.01).round() as usize;
    assert_eq!(block.cells, [32, 32, wall + 1 + 7]);
    // The record of the run has them too.
    let settings = &case.settings["rock"];
    assert_eq!(settings["density_factor"], 50.0);
    assert_eq!(settings["cells"][0], 32);
    assert_eq!(case.settings["bit"]["face"]["blades"], 6);
}

/// A crushed band is 2 mm wide.
#[test]
fn the_energy_of_a_crushed_band_follows_that_of_crushing() {
    let case = on_rock("", &format!("{SOUND}\ncrushing_energy = \"6 MPa\""), "");
    let rock = spec(&case).block.rock;
    assert_eq!(rock.crushing_energy_J_per_m3, 6e6);
    assert!((rock.compressive_fracture_energy_J_per_m2 / 12e3 - 1.0).abs() < 1e-12);
}

/// An element is no larger than the clearance between the body and the tips of the cutters allows.
#[test]
fn elements_follow_the_cutters() {
    let case = on_rock("", SOUND, "[bit.face]\nexposure = \"6 mm\"");
    assert!((spec(&case).block.size_m[0] - 9e-3).abs() < 1e-12);
}

/// The mud's pressure acts on all sides by default.
#[test]
fn confinement_is_the_pressure() {
    let case = on_rock("", &format!("{SOUND}\npressure = \"10 MPa\""), "");
    assert_eq!(spec(&case).block.confinement_Pa, 10e6);
}

#[test]
fn every_number_of_the_face_arrives() {
    let case = on_rock(
        "kind = \"core\"\ncore_diameter = \"4 in\"",
        SOUND,
        "[bit.face]\nblades = 8\ncutters_per_blade = 3\ncutters_per_track = 2\ncutter_diameter = 0.013\n\
         cutter_length = \"8 mm\"\nchamfer = \"0.2 mm\"\nback_rake = 20\nside_rake = 3\nspiral = 10\nexposure = \"5 mm\"\n\
         blade_width = \"30 mm\"\ncentre_spacing = 1.1\ngauge_length = \"60 mm\"\ngauge_relief = \"0.5 mm\"",
    );
    let degree = PI / 180.0;
    let expected = PdcBit {
        blades: 8,
        cutters_per_blade: 3,
        cutters_per_track: 2,
        cutter_diameter_m: 0.013,
        cutter_length_m: 0.008,
        chamfer_m: 0.2e-3,
        back_rake_rad: 20.0 * degree,
        side_rake_rad: 3.0 * degree,
        spiral_rad: 10.0 * degree,
        exposure_m: 0.005,
        blade_width_m: 0.03,
        centre_spacing: 1.1,
        gauge_length_m: 0.06,
        gauge_relief_m: 0.5e-3,
        ..PdcBit::core(OD_M, 0.1016)
    };
    assert_eq!(pdc(&case), expected);
}

/// Defaults that depend on a number follow the given value.
#[test]
fn defaults_follow_what_is_given() {
    let bit = pdc(&on_rock("", SOUND, "[bit.face]\ncutter_diameter = \"13 mm\""));
    assert!((bit.cutter_length_m - 0.8 * 0.013).abs() < 1e-15);
    assert!((bit.exposure_m - 0.5 * 0.013).abs() < 1e-15);
    assert!(bit.cutters_per_blade > PdcBit::for_diameter(OD_M).cutters_per_blade);
}

#[test]
fn inserts() {
    let case = on_rock(
        "kind = \"inserts\"",
        SOUND,
        "[bit.face]\ninsert_diameter = \"16 mm\"\ninsert_shape = \"cone\"\ncone_angle = 8",
    );
    let expected = InsertBit {
        insert_diameter_m: 0.016,
        protrusion_m: 0.008,
        pitch_m: 0.024,
        shape: InsertShape::Cone { half_angle_rad: 35.0 * (PI / 180.0), tip_radius_m: 0.004 },
        cone_angle_rad: 8.0 * (PI / 180.0),
        ..InsertBit::for_diameter(OD_M)
    };
    assert_eq!(spec(&case).bit, BitShape::Insert(expected.filled()));
}

/// A grid around the operation's weight on bit and rotary speed, sampled as a run is.
#[test]
fn a_bit_test_without_keys() {
    let case = on_rock("", SOUND, "");
    let test = test(&case);
    let weight_N = 6.0 * 9806.65;
    let speed = 70.0 * PI / 30.0;
    for (found, factor) in test.weights_N.iter().zip([0.25, 0.5, 1.0, 1.5, 2.0]) {
        assert!((found / (factor * weight_N) - 1.0).abs() < 1e-12);
    }
    for (found, factor) in test.rotary_speeds_rad_per_s.iter().zip([0.5, 1.0, 1.5]) {
        assert!((found / (factor * speed) - 1.0).abs() < 1e-12);
    }
    assert_eq!(test.averaging_s, case.dynamics.sample_interval_s);
    // The mean of the weights is 1.05 of the operation's.
    assert!((test.mass_kg / 6300.0 - 1.0).abs() < 1e-12);
    assert_eq!(&test.drilling, spec(&case));
    // Six revolutions at each point: 5 weights, 6 × 60 s/35, 70, 105.
    let time_s = 5.0 * 6.0 * 60.0 / 70.0 * (2.0 + 1.0 + 2.0 / 3.0);
    assert!((test.time_s() / time_s - 1.0).abs() < 1e-12);
}

#[test]
fn a_bit_test_of_other_points() {
    let case = on_rock(
        "",
        SOUND,
        "[bit_test]\nwob = [\"80 kN\", \"40 kN\"]\nrpm = 120\nsettle_revolutions = 1\nrevolutions = 3\nmass = \"5 t\"\n\
         averaging = \"20 ms\"\nstep = \"1 ms\"",
    );
    let test = test(&case);
    assert_eq!(test.weights_N, [40e3, 80e3]);
    assert_eq!(test.rotary_speeds_rad_per_s.len(), 1);
    assert!((test.rotary_speeds_rad_per_s[0] - 4.0 * PI).abs() < 1e-12);
    assert_eq!([test.settle_revolutions, test.revolutions], [1.0, 3.0]);
    assert_eq!(test.mass_kg, 5000.0);
    assert_eq!([test.averaging_s, test.step_s], [0.02, 1e-3]);
    assert_eq!(case.settings["bit_test"]["mass_kg"], 5000.0);
}

/// The law of the run may be another one: a table that the test is to measure.
#[test]
fn a_bit_test_beside_another_law() {
    let text = changed("[rig]", "[rock]\nstrength = \"60 MPa\"\n[bit_test]\n[rig]");
    let case = read(&text).unwrap_or_else(|report| panic!("{report}"));
    assert!(matches!(case.dynamics.bit.law, BitLaw::Rate(_)));
    assert_eq!(test(&case).weights_N.len(), 5);
    assert!(case.drilling().is_some());
    // Without a bit test there is no rock, and none in the record.
    let plain = read(common::EXAMPLE).expect("the example");
    assert!(plain.drilling().is_none() && plain.bit_test.is_none());
    assert!(plain.settings.get("rock").is_none());
}
