//! Regions with steps of their own, against one step for all of the string.

mod energy;
mod order;
mod stability;
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
        stability::StepPlan,
    },
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
        mesh.elements.push(MeshElement { length_m, section });
        mesh.nodes.push(node(low));
        from_bit_m = low;
    }
    mesh
}

/// A rod of pipe alone: `long` elements of ordinary length, and below them `pieces` more, each cut
/// in `parts`, in the regions of its plan.
fn refined(long: usize, pieces: usize, parts: usize) -> Bench {
    let mut lengths = vec![LONG_M; long];
    lengths.extend(vec![LONG_M / parts as f64; pieces * parts]);
    rod_of(&lengths, |_, _| {}).divided()
}

/// A rod of pipe in elements of these lengths from the top down, m, with a plan that `change` has
/// changed; it is given an ordinary element's stiffness.
fn rod_of(lengths_m: &[f64], change: impl Fn(&mut StepPlan, &Stiffness<f64>)) -> Bench {
    let length_m: f64 = lengths_m.iter().sum();
    let [od, id] = PIPE_M;
    let pipe = ComponentSpec::uniform("rod", od, id, ComponentLength::Metres(length_m), STEEL);
    let path = arcs(&[[0.0; 3], [length_m, 0.0, 0.0]]);
    let model = common::model(path, open_hole(2.0, 0.0, length_m), vec![pipe], mud(0.0), length_m);
    let mesh = mesh_of(&model, lengths_m);
    let lateral = chain::lateral_mass_kg_per_m(&model, &mesh, length_m);
    let mut plan = regions::plan(&mesh, &lateral, 0.0, usize::MAX);
    change(&mut plan, &Stiffness::new(&mesh.elements[0].section, LONG_M));
    Bench::of_mesh(model, mesh, plan, 0.0)
}
