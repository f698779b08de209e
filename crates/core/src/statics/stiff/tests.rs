use super::*;
use crate::{
    common::{self, number, verification},
    operation::Operation,
    sizing::ElementLength,
    string::{Blades, ComponentLength, ComponentSpec, Material},
    wall::contact::ContactLaw,
};

fn rigid() -> ContactLaw {
    ContactLaw::Linear { stiffness_N_per_m: 1e10, damping_ratio: 0.0 }
}

#[test]
fn s1b_assemblies() {
    let data = verification("S1b_bha_stabilisers_straight_hole.json");
    let inputs = &data["inputs"];
    let collar = |key: &str| number(&inputs["collar"][key]);
    let hole_m = number(&inputs["hole_diameter_m"]);
    for case in data["cases"].as_array().expect("cases") {
        let input = &case["inputs"];
        let stabilisers: Vec<f64> = input["stabilisers_from_bit_m"]
            .as_array()
            .expect("a list")
            .iter()
            .map(number)
            .collect();
        let length_m = 120.0;
        let steel = Material {
            youngs_modulus_Pa: collar("E"),
            shear_modulus_Pa: collar("G"),
            ..common::steel()
        };
        let mut parts = Vec::new();
        let mut from = 0.0;
        let piece = |length: f64| ComponentSpec {
            mass_per_length_kg_per_m: collar("w") / crate::GRAVITY_M_PER_S2,
            ..ComponentSpec::uniform(
                "collar",
                collar("od"),
                collar("id"),
                ComponentLength::Metres(length),
                steel,
            )
        };
        for at in &stabilisers {
            parts.push(piece(at - 0.05 - from));
            parts.push(ComponentSpec {
                blades: Some(Blades { od_m: number(&inputs["stabiliser_od_m"]), length_m: 0.05 }),
                ..piece(0.1)
            });
            from = at + 0.05;
        }
        parts.push(piece(length_m - from));
        let path = common::arcs(&[
            [0.0, number(&input["inc_deg"]), 0.0],
            [length_m, number(&input["inc_deg"]), 0.0],
        ]);
        let model = common::model(
            path,
            common::open_hole(hole_m, 0.0, length_m),
            parts,
            common::mud(0.0),
            length_m,
        );
        let operation = Operation {
            weight_on_bit_N: number(&input["WOB_N"]),
            trip_speed_m_per_s: 0.1,
            ..Operation::slide(length_m)
        };
        let settings = StiffSettings {
            element_length: ElementLength::Uniform(0.3),
            contact_law: rigid(),
            bit_lateral_stiffness_N_per_m: 1e10,
            ..StiffSettings::default()
        };
        let started = std::time::Instant::now();
        let solved = solve(&model, &operation, &settings).expect("a string");
        let ms = started.elapsed().as_secs_f64() * 1e3;
        let side = solved.bit_side_force_N[0];
        let blades: Vec<f64> = stabilisers
            .iter()
            .map(|at| {
                let md_m = length_m - at;
                let near = (0..solved.md_m.len())
                    .min_by(|a, b| {
                        (solved.md_m[*a] - md_m).abs().total_cmp(&(solved.md_m[*b] - md_m).abs())
                    })
                    .expect("nodes");
                solved.contact_force_N[near]
            })
            .collect();
        eprintln!(
            "{} {:?} {} {ms:.1} ms: {side:.1} of {} {}; blades {blades:?} of {}",
            case["id"],
            solved.convergence.iterations,
            solved.convergence.stable,
            case["timoshenko"]["bit_side_force_on_rock_N_pos_high"],
            case["expected"]["bit_side_force_on_rock_N_pos_high"],
            case["timoshenko"]["stabiliser_force_on_wall_N_pos_high"]
        );
    }
}
