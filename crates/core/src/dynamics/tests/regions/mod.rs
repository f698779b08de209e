//! Regions with steps of their own, against one step for all of the string.

mod energy;
mod order;
mod plan;
mod spectral_radius;
mod waves;

use super::bench::{Bench, PIPE_M, STEEL};
use crate::{
    common::{self, arcs, mud, open_hole},
    dynamics::assemble::chain,
    model::Model,
    rod::{
        element::Stiffness,
        mesh::{Mesh, MeshElement, MeshNode},
        regions,
        section::Section,
        stability::{self, StepPlan, Subcycling},
    },
    sizing::SizeReason,
    string::{ComponentLength, ComponentSpec},
};

/// Length of the elements of ordinary pipe, m.
const LONG_M: f64 = 9.6;

/// A mesh of `string` with elements of these lengths from the top down, m.
fn mesh_of(model: &Model, lengths_m: &[f64]) -> Mesh {
    let radius = 0.5 * PIPE_M[0];
    let node = |from_bit_m: f64| MeshNode { from_bit_m, contact_radius_m: radius };
    let mut from_bit_m: f64 = lengths_m.iter().sum();
    let mut mesh = Mesh { nodes: vec![node(from_bit_m)], elements: Vec::new() };
    for &length_m in lengths_m {
        let low = from_bit_m - length_m;
        let section = Section::between(&model.string, low, from_bit_m);
        mesh.elements.push(MeshElement { length_m, section, reason: SizeReason::Given });
        mesh.nodes.push(node(low));
        from_bit_m = low;
    }
    mesh
}

/// A rod of pipe alone: `long` elements of ordinary length, and below them `pieces` more, each cut
/// in `parts`, in two regions.
fn refined(long: usize, pieces: usize, parts: usize) -> Bench {
    let mut lengths = vec![LONG_M; long];
    lengths.extend(vec![LONG_M / parts as f64; pieces * parts]);
    let divided = |mesh: &Mesh, lateral: &[f64]| regions::divided(mesh, lateral, 0.0, usize::MAX);
    rod_of(&lengths, |mesh, lateral| divided(mesh, lateral).expect("short elements below"))
        .divided()
}

/// A rod of equal elements whose lower region, below `border_node`, takes `parts` steps in one of
/// the others. The longest step is used to `part_of_step`, the inertia that the coupling lacks is
/// added to its `part_of_inertia`.
fn equal(elements: usize, border_node: usize, parts: u32, fractions: [f64; 2]) -> Bench {
    rod_of(&vec![LONG_M; elements], |mesh, lateral| {
        let [part_of_step, part_of_inertia] = fractions;
        let mut plan = stability::plan(mesh, lateral, 0.0);
        plan.dt_s *= part_of_step;
        let k = Stiffness::new(&mesh.elements[0].section, LONG_M);
        let m = f64::from(parts);
        let beside_s2 = part_of_inertia * plan.dt_s.powi(2) / 12.0 * (1.0 - 1.0 / (m * m));
        plan.subcycling = Some(Subcycling {
            border_node,
            parts,
            axial_kg: k.axial * beside_s2,
            polar_kg_m2: k.twist * beside_s2,
            holder: None,
        });
        plan
    })
}

/// A rod of pipe in elements of these lengths from the top down, m, with the plan that `plan` makes
/// of its mesh and lateral mass.
fn rod_of(lengths_m: &[f64], plan: impl Fn(&Mesh, &[f64]) -> StepPlan) -> Bench {
    let model = model_of(lengths_m);
    let mesh = mesh_of(&model, lengths_m);
    let lateral = chain::lateral_mass_kg_per_m(&model, &mesh, mesh.length_m());
    let plan = plan(&mesh, &lateral);
    Bench::of_mesh(model, mesh, plan, 0.0)
}

/// Pipe as long as these elements, upright in a wide hole without mud.
fn model_of(lengths_m: &[f64]) -> Model {
    let length_m: f64 = lengths_m.iter().sum();
    let [od, id] = PIPE_M;
    let pipe = ComponentSpec::uniform("rod", od, id, ComponentLength::Metres(length_m), STEEL);
    let path = arcs(&[[0.0; 3], [length_m, 0.0, 0.0]]);
    common::model(path, open_hole(2.0, 0.0, length_m), vec![pipe], mud(0.0), length_m)
}
