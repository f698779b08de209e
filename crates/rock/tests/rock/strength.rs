//! Strength of one element against E07's identities, and the tip of the cone.

use wholestring_rock::{Edge, Rock, Stepper};
use wholestring_verification::{file, report_worst, verify};

use crate::setup::{cauchy_Pa, ductile, one_element, press, step, tell_layer_down};

/// The rocks of E07, with its numbers.
fn rocks() -> Vec<(Rock, serde_json::Value)> {
    let file = file("E07_bit_rock_detournay.json");
    let rows = file["drucker_prager"].as_array().expect("rows").clone();
    rows.into_iter()
        .map(|row| {
            let number = |key: &str| row[key].as_f64().expect("a number");
            let friction_angle_rad = number("phi_deg").to_radians();
            let rock = Rock {
                youngs_modulus_Pa: 100e9,
                cohesion_Pa: 1e6 * number("c_MPa"),
                friction_angle_rad,
                ..ductile(Rock::of_strength(50e6))
            };
            (rock, row)
        })
        .collect()
}

/// Presses an element under a lateral pressure along z to a strain; returns the largest axial
/// stress in excess of the initial one, Pa.
fn strength_Pa(rock: Rock, pressure_Pa: f64, strain: f64) -> f64 {
    let stepper = Stepper::default();
    let mut block = press(rock, pressure_Pa);
    let steps = 40_000;
    let speed = strain * 1e-3 / (f64::from(steps) * block.dt_s());
    tell_layer_down(&mut block, 1, speed);
    for _ in 0..steps {
        step(&mut block, &stepper);
    }
    cauchy_Pa(&block)[2]
}

#[test]
fn the_cone_is_matched_in_compression() {
    for (rock, row) in rocks() {
        let number = |key: &str| row[key].as_f64().expect("a number");
        let cone = rock.cone();
        let name = format!("{} deg", number("phi_deg"));
        for (quantity, expected, computed) in [
            ("alpha", number("alpha_comp"), cone.alpha),
            ("k, MPa", number("k_comp_MPa"), 1e-6 * cone.k_Pa),
            ("unconfined strength, MPa", number("UCS_MPa"), 1e-6 * rock.ucs_Pa()),
            (
                "slope in the plane of mean and equivalent stress, deg",
                number("abaqus_beta_deg"),
                (27.0_f64.sqrt() * cone.alpha).atan().to_degrees(),
            ),
        ] {
            verify("E07", format!("cone at {name}: {quantity}"))
                .relative(1e-12, "closed forms")
                .report(expected, computed);
        }
    }
}

#[test]
fn a_pressed_element_bears_the_unconfined_strength() {
    report_worst(rocks().into_iter().map(|(rock, row)| {
        verify("E07", "strength of an element in uniaxial compression, MPa")
            .relative(1e-3, "required; the stress that is bounded is Kirchhoff's")
            .row(row["UCS_MPa"].as_f64().expect("a number"), -1e-6 * strength_Pa(rock, 0.0, -3e-3))
    }));
}

#[test]
fn a_confined_element_bears_the_triaxial_strength() {
    let confinement_Pa = 20e6;
    report_worst(rocks().into_iter().map(|(rock, row)| {
        let sin = rock.friction_angle_rad.sin();
        let expected = row["UCS_MPa"].as_f64().expect("a number")
            + 1e-6 * confinement_Pa * (1.0 + sin) / (1.0 - sin);
        verify("E07", "strength of an element in triaxial compression under 20 MPa, MPa")
            .relative(1e-3, "required; the stress that is bounded is Kirchhoff's")
            .row(expected, -1e-6 * strength_Pa(rock, confinement_Pa, -5e-3))
    }));
}

#[test]
fn a_pulled_element_bears_the_tensile_strength() {
    let rock = Rock { youngs_modulus_Pa: 100e9, ..ductile(Rock::of_strength(50e6)) };
    verify("rock", "strength of an element in uniaxial tension, MPa")
        .relative(1e-3, "the stress that is bounded is Kirchhoff's")
        .report(1e-6 * rock.tensile_strength_Pa, 1e-6 * strength_Pa(rock, 0.0, 1.5e-4));
}

#[test]
fn a_torn_element_returns_to_the_apex() {
    let rock = Rock { tensile_strength_Pa: 1e12, ..ductile(Rock::of_strength(50e6)) };
    let mut block = one_element(rock, [Edge::Held; 6], 0.0);
    let grid = *block.grid();
    // Swelling with some shear, far beyond the tip.
    for node in grid.each_node() {
        let [x, y, z] = [0, 1, 2].map(|a| node[a] as f64 * grid.size_m[a] * 1e-2 / block.dt_s());
        block.tell(grid.node(node), [x + 0.1 * y, 1.1 * y, 0.9 * z]);
    }
    step(&mut block, &Stepper::default());
    let stress = block.stress_Pa([0, 0, 0]);
    let cone = rock.cone();
    verify("rock", "first invariant at the apex, Pa")
        .relative(1e-9, "a closed form")
        .report(cone.k_Pa / cone.alpha, stress[0] + stress[1] + stress[2]);
    let mean = (stress[0] + stress[1] + stress[2]) / 3.0;
    let shear = stress
        .iter()
        .take(3)
        .map(|s| (s - mean).abs())
        .chain(stress.iter().skip(3).map(|s| s.abs()));
    verify("rock", "largest deviatoric stress at the apex, Pa")
        .absolute(1.0, "a closed form, at stresses of 1e7")
        .report(0.0, shear.fold(0.0, f64::max));
}
