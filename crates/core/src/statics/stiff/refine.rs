//! Elements that are too long for the bending of the solution, and the error that they cause.

use super::{
    bending::Bending, equilibrium::Equilibrium, mesh_error::MeshError, profile::hook_and_torque,
    string_in_hole::STANDS_OUT_M,
};

/// Part of the tolerance by which the peak of an element's moment may exceed its moments at the
/// nodes and half-way.
const PEAK: f64 = 0.5;

/// Part of its clearance by which the body of an element may penetrate the wall between its nodes,
/// and the smallest penetration that counts, m.
const BULGE: f64 = 0.02;
const LEAST_BULGE_M: f64 = 2e-4;

/// Elements shorter than this are not divided, m.
const SHORTEST_M: f64 = 0.2;

impl Equilibrium {
    /// The elements that are too long: those in which a contact of the body begins or ends, whose
    /// body touches between nodes that are off the wall, whose moment differs from that of their
    /// neighbours by more than a part of the largest one, or whose nodes miss a peak between them.
    pub(super) fn too_long(&self, tolerance: f64) -> Vec<bool> {
        let bending = self.bending();
        let most_N_m = tolerance * bending.at_node_N_m.iter().copied().fold(0.0, f64::max);
        let apart = |node: usize| bending.jump_N_m[node] > most_N_m;
        let lies: Vec<bool> = (0..self.mesh.nodes.len()).map(|node| self.body_lies(node)).collect();
        let touches = |node: usize| self.state.normal_N[node] > 0.0;
        let mut long = vec![false; self.mesh.elements.len()];
        for element in 0..long.len() {
            let ends = [element, element + 1];
            let between = bending.touches[element] > 0.0 && !ends.iter().all(|node| lies[*node]);
            let lifts =
                [(0, 1), (1, 0)].iter().any(|(on, off)| lies[ends[*on]] && !touches(ends[*off]));
            let cut = self.mesh.elements[element].length_m > SHORTEST_M
                && (between
                    || lifts
                    || ends.iter().any(|node| apart(*node))
                    || self.misses(element, &bending, most_N_m));
            long[element] |= cut;
            // It may lift off on the other side of the node, too.
            if cut && lifts {
                let next = if lies[element] { element.checked_sub(1) } else { Some(element + 1) };
                if let Some(next) = next.and_then(|index| long.get_mut(index)) {
                    *next = true;
                }
            }
        }
        long
    }

    /// Whether any element needs to be divided, however little the last halving changed at the
    /// nodes.
    pub(super) fn any_unresolved(&self, tolerance: f64) -> bool {
        let bending = self.bending();
        let most_N_m = tolerance * bending.at_node_N_m.iter().copied().fold(0.0, f64::max);
        let long = |element: &usize| self.mesh.elements[*element].length_m > SHORTEST_M;
        let mut elements = (0..self.mesh.elements.len()).filter(long);
        elements.any(|element| self.misses(element, &bending, most_N_m))
    }

    /// Whether nodes and middle of an element miss a peak of the moment between them, or a body
    /// that penetrates the wall there.
    fn misses(&self, element: usize, bending: &Bending, most_N_m: f64) -> bool {
        let clearance_m = self.string.elements[element].body_clearance_m;
        let in_hole = [element, element + 1].iter().any(|node| self.string.nodes[*node].has_wall());
        let bulges =
            || in_hole && self.bulges_m(element) > (BULGE * clearance_m).max(LEAST_BULGE_M);
        bending.peak_excess_N_m[element] > PEAK * most_N_m || bulges()
    }

    /// Whether the body at a node, and no joint or blade, touches the wall.
    fn body_lies(&self, node: usize) -> bool {
        let clearance_m = self.string.nodes[node].clearance_m;
        let adjacent = [node.checked_sub(1), Some(node)].into_iter().flatten();
        let mut bodies = adjacent.filter_map(|index| self.string.elements.get(index));
        self.state.normal_N[node] > 0.0
            && bodies.all(|body| body.body_clearance_m < clearance_m + STANDS_OUT_M)
    }

    /// Error of a coarser mesh whose nodes are all nodes of this one's: the differences between the
    /// two.
    pub(super) fn change_since(&self, coarser: &Self) -> MeshError {
        let [[hook_N, torque_N_m], [was_N, was_N_m]] = [self, coarser].map(hook_and_torque);
        let [moments, were] = [self, coarser].map(|one| one.bending().at_node_N_m);
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

    fn bending(&self) -> Bending {
        Bending::of(&self.string, &self.state, &self.mesh)
    }

    /// The largest bending moment at a node, N·m.
    pub(super) fn largest_moment_N_m(&self) -> f64 {
        self.bending().at_node_N_m.iter().copied().fold(0.0, f64::max)
    }
}
