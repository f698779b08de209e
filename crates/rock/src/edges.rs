//! The outer faces of a block.

use serde::{Deserialize, Serialize};

use super::{constants::Constants, grid::Grid};

/// Boundary condition of an outer face.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Edge {
    /// The fluid in the hole: its pressure, and external forces. Only such a face can be touched.
    Free,
    /// Nodes move as prescribed: not at all, unless they were given a velocity.
    Held,
    /// Nodes move across the face as prescribed, and freely along it: a plane of symmetry.
    Guided,
    /// More rock of the same kind, under the stress that the block had at first. Waves that arrive
    /// squarely pass: each area `A` is a dashpot `ρ c_p A` across and `ρ c_s A` along the face
    /// (Lysmer and Kuhlemeyer 1969).
    Open,
}

/// Boundary condition of a node of an outer face.
#[derive(Debug, Clone, Copy, Default)]
struct Outside {
    place: usize,
    held: [bool; 3],
    /// N·s/m.
    dashpot: [f64; 3],
    /// N.
    traction_N: [f64; 3],
    /// Velocity before the step, m/s.
    before: [f64; 3],
}

/// All nodes of outer faces that something acts on.
#[derive(Debug, Clone, Default)]
pub struct Edges(Vec<Outside>);

/// Work of the outer faces on the block in a step, J.
#[derive(Debug, Clone, Copy, Default)]
pub struct EdgeWork {
    /// Work of held nodes and of the rock beyond.
    pub done_J: f64,
    /// Energy absorbed by dashpots.
    pub absorbed_J: f64,
}

impl Edges {
    /// Faces −x, +x, −y, +y, −z, +z; `stress_Pa` is the initial stress across x, y and z above that
    /// of the filling.
    pub fn new(grid: &Grid, faces: &[Edge; 6], stress_Pa: [f64; 3], constants: &Constants) -> Self {
        let mut found = Vec::new();
        for node in grid.each_node() {
            let mut outside = Outside { place: grid.node(node), ..Outside::default() };
            for (face, edge) in faces.iter().enumerate() {
                let (axis, far) = (face / 2, face % 2 == 1);
                if node[axis] != if far { grid.cells[axis] } else { 0 } {
                    continue;
                }
                // A quarter of the face of each element around the node.
                let quarters: f64 = [(axis + 1) % 3, (axis + 2) % 3]
                    .map(|a| if node[a] == 0 || node[a] == grid.cells[a] { 0.5 } else { 1.0 })
                    .iter()
                    .product();
                let area_m2 = quarters * grid.area_m2(face);
                match edge {
                    Edge::Free => {}
                    Edge::Held => outside.held = [true; 3],
                    Edge::Guided => outside.held[axis] = true,
                    Edge::Open => {
                        for (direction, dashpot) in outside.dashpot.iter_mut().enumerate() {
                            *dashpot +=
                                area_m2 * constants.impedance[usize::from(direction != axis)];
                        }
                        let outwards = if far { 1.0 } else { -1.0 };
                        outside.traction_N[axis] += outwards * area_m2 * stress_Pa[axis];
                    }
                }
            }
            if outside.held != [false; 3] || outside.dashpot != [0.0; 3] {
                found.push(outside);
            }
        }
        found.sort_by_key(|node: &Outside| node.place);
        Self(found)
    }

    /// The directions in which a node moves as prescribed.
    pub fn held(&self, place: usize) -> [bool; 3] {
        let found = self.0.binary_search_by_key(&place, |node| node.place);
        found.map_or([false; 3], |index| self.0[index].held)
    }

    /// Keeps the velocities before a step.
    pub fn remember(&mut self, velocity: &[Vec<f64>; 3]) {
        let [x, y, z] = velocity;
        for node in &mut self.0 {
            node.before = [x[node.place], y[node.place], z[node.place]];
        }
    }

    /// Holds, brakes and loads the nodes that the rock has just kicked.
    pub fn act(&self, velocity: &mut [Vec<f64>; 3], inverse_mass: &[f64], dt_s: f64) -> EdgeWork {
        let mut work = EdgeWork::default();
        for node in &self.0 {
            let inverse = inverse_mass[node.place];
            if inverse <= 0.0 {
                continue;
            }
            for (axis, velocity) in velocity.iter_mut().enumerate() {
                let v = &mut velocity[node.place];
                let (before, kicked) = (node.before[axis], *v);
                if node.held[axis] {
                    *v = before;
                    work.done_J += before * (before - kicked) / inverse;
                    continue;
                }
                // The dashpot acts on the mean of the velocities before and after.
                let push = dt_s * node.traction_N[axis] * inverse;
                let half = 0.5 * dt_s * node.dashpot[axis] * inverse;
                *v = (kicked + push - half * before) / (1.0 + half);
                let mean = 0.5 * (before + *v);
                work.done_J += mean * dt_s * node.traction_N[axis];
                work.absorbed_J += mean * mean * dt_s * node.dashpot[axis];
            }
        }
        work
    }
}
