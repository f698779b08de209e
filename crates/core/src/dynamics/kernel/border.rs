//! Coupling of two regions with different time steps at the element between them.
//!
//! Belytschko's nodal partition with linear interpolation: the upper region steps first, with the
//! border element evaluated at its position at the step's beginning. In the lower region's steps
//! within it, the border node moves at the constant velocity from that step. Theory:
//! `docs/src/theory/time-stepping.md`.

use super::{
    chain::{Chain, Rows, element, node},
    places::Border,
};
use crate::{
    rod::element::{self, Pose},
    simd::{number::Real, vector::Vector},
};

/// A coupled step of both regions on its way.
#[derive(Debug, Clone, Copy)]
pub struct Coupled {
    border: Border,
    /// Director of the border node at the step's beginning.
    director: Vector<f64>,
    /// Power that stiffness-proportional damping takes of the border element as the upper region
    /// has it, W: the lower region books it, too.
    pub damping_W: f64,
}

impl Coupled {
    /// Before a step of the upper region, of length `dt`: exchanges the data that the regions read
    /// from each other. Returns none where the chain is not divided.
    pub fn begin<R: Real>(chain: &mut Chain<R>, dt: f64, stiffness_damping: f64) -> Option<Self> {
        let border = chain.border()?;
        chain.set_ghosts();
        let index = border.node;
        let k = chain.stiffness(index);
        let pose = Pose { twist: chain.lower_twist(index), ..chain.pose(index) };
        // The lower region has carried its twist on to its own last step: the step will carry it on
        // by all of `dt`.
        let ahead = dt / f64::from(border.parts) - dt;
        let twisted = element::twist(&k, &pose, ahead, stiffness_damping);
        element!(chain, index, twist = twisted.twist);
        let lengthening = element::chord(&k, &pose).direction.dot(pose.velocity);
        let stretched_W = k.axial * stiffness_damping * lengthening * lengthening;
        let damping_W = twisted.damping_power + stretched_W;
        Some(Self { border, director: chain.director(index), damping_W })
    }

    /// After the first of the lower region's steps of `dt`, which has moved the border node's ghost
    /// at the velocity before the step of the upper region: from now on it moves at the velocity
    /// after it. The terms that depend on velocities (twist, damping) therefore lag by half a step
    /// at both ends.
    pub fn lead<R: Real>(&self, chain: &mut Chain<R>, dt: f64) {
        let Some([_, (row, lane)]) = chain.ghosts() else {
            return;
        };
        let index = self.border.node;
        let (velocity, turning) = (chain.velocity(index), chain.turning(index));
        let spin = node!(chain, index, spin);
        let state = &mut chain.states[row];
        let before = read(&state.v, lane);
        let moved = read(&state.u, lane).plus(velocity - before, dt);
        // Cayley's rotation, as in the step.
        let q = 0.25 * dt * dt * turning.dot(turning);
        let director = self.director;
        let turned =
            director.scaled((1.0 - q) / (1.0 + q)).plus(turning.cross(director), dt / (1.0 + q));
        write(&mut state.u, lane, moved);
        write(&mut state.v, lane, velocity);
        write(&mut state.d, lane, turned);
        write(&mut state.w, lane, turning);
        state.spin.0[lane] = R::from_f64(spin);
    }
}

fn read<R: Real>(rows: &Rows<R>, lane: usize) -> Vector<f64> {
    let [x, y, z] = rows.each_ref().map(|row| row.0[lane].to_f64());
    Vector(x, y, z)
}

fn write<R: Real>(rows: &mut Rows<R>, lane: usize, v: Vector<f64>) {
    for (row, value) in rows.iter_mut().zip([v.0, v.1, v.2]) {
        row.0[lane] = R::from_f64(value);
    }
}
