//! Where a mesh is too coarse for the contacts that it shows, and what that is worth.

use super::{bending::Bending, equilibrium::Equilibrium, profile::hook_and_torque};
use crate::model::Model;

/// How much farther than the body a node of a joint or a blade stands out, m.
const STANDS_OUT_M: f64 = 1e-4;

/// What the elements' lengths leave uncertain, by the last two meshes.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MeshError {
    /// Hook load, N.
    pub hook_load_N: f64,
    /// Surface torque, N·m.
    pub surface_torque_N_m: f64,
    /// Sum of the contact forces, N.
    pub side_force_total_N: f64,
    /// Bending moment at a node, N·m: the largest change.
    pub bending_moment_N_m: f64,
    /// Where that is, measured depth, m.
    pub md_m: f64,
}

impl Equilibrium {
    /// The elements in which a contact of the body begins or ends, and those whose body touches
    /// between nodes that do not lie on the wall.
    pub(super) fn contact_edges(&self, model: &Model) -> Vec<bool> {
        let bending = self.bending(model);
        let lies: Vec<bool> = (0..self.mesh.nodes.len()).map(|node| self.body_lies(node)).collect();
        let touches = |node: usize| self.state.normal_N[node] > 0.0;
        let mut edges = vec![false; self.mesh.elements.len()];
        for element in 0..edges.len() {
            let ends = [element, element + 1];
            let between = bending.touches[element] > 0.0 && !ends.iter().all(|node| lies[*node]);
            let lifts =
                [(0, 1), (1, 0)].iter().any(|(on, off)| lies[ends[*on]] && !touches(ends[*off]));
            edges[element] = between || lifts;
            // It may lift off on the other side of the node, too.
            if lifts {
                let beside = if lies[element] { element.checked_sub(1) } else { Some(element + 1) };
                if let Some(edge) = beside.and_then(|index| edges.get_mut(index)) {
                    *edge = true;
                }
            }
        }
        edges
    }

    /// Whether the body of a node, and no joint or blade, lies on the wall.
    fn body_lies(&self, node: usize) -> bool {
        let clearance_m = self.string.nodes[node].clearance_m;
        let beside = [node.checked_sub(1), Some(node)].into_iter().flatten();
        let mut bodies = beside.filter_map(|index| self.string.elements.get(index));
        self.state.normal_N[node] > 0.0
            && bodies.all(|body| body.body_clearance_m < clearance_m + STANDS_OUT_M)
    }

    /// What a mesh whose nodes all belong to this one's left uncertain.
    pub(super) fn change_since(&self, coarser: &Self, model: &Model) -> MeshError {
        let [[hook_N, torque_N_m], [was_N, was_N_m]] = [self, coarser].map(hook_and_torque);
        let [moments, were] = [self, coarser].map(|one| one.bending(model).at_node_N_m);
        let pressed_N = |one: &Self| one.state.normal_N.iter().sum::<f64>();
        let mut error = MeshError {
            hook_load_N: (hook_N - was_N).abs(),
            surface_torque_N_m: (torque_N_m - was_N_m).abs(),
            side_force_total_N: (pressed_N(self) - pressed_N(coarser)).abs(),
            ..MeshError::default()
        };
        let mut fine = 0;
        for (node, was_N_m) in coarser.mesh.nodes.iter().zip(were) {
            while self.mesh.nodes[fine].from_bit_m > node.from_bit_m {
                fine += 1;
            }
            let change_N_m = (moments[fine] - was_N_m).abs();
            if change_N_m > error.bending_moment_N_m {
                (error.bending_moment_N_m, error.md_m) = (change_N_m, self.string.nodes[fine].md_m);
            }
        }
        error
    }

    fn bending(&self, model: &Model) -> Bending {
        Bending::of(&self.string, &self.state, &self.mesh, model.mud.density_kg_per_m3)
    }

    /// The largest bending moment at a node, N·m.
    pub(super) fn largest_moment_N_m(&self, model: &Model) -> f64 {
        self.bending(model).at_node_N_m.iter().copied().fold(0.0, f64::max)
    }
}
