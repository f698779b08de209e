//! What the elements do to their ends.

use super::{
    Losses, StepInput, TILE,
    lane::{Eight, add, at, at3, from, nine, put},
};
use crate::{
    dynamics::chain::{ElementBlock, State},
    rod::{
        element::{Pose, Stiffness, react},
        lanes::LANES,
        number::Number,
    },
};

/// One number for each element of a tile, after that of the last element of the tile above.
pub(super) type Strip = [f64; TILE * LANES + 1];

/// What the elements of a tile do to their ends.
pub(super) struct Pull {
    pub(super) force: [Strip; 3],
    pub(super) moment1: [Strip; 3],
    pub(super) moment2: [Strip; 3],
    pub(super) torque: Strip,
}

impl Pull {
    pub(super) const NONE: Self = Self {
        force: [[0.0; TILE * LANES + 1]; 3],
        moment1: [[0.0; TILE * LANES + 1]; 3],
        moment2: [[0.0; TILE * LANES + 1]; 3],
        torque: [0.0; TILE * LANES + 1],
    };

    /// Carries what the last element of a tile of `elements` does to the first node of the next.
    pub(super) fn carry(&mut self, elements: usize) {
        for strip in self.force.iter_mut().chain(&mut self.moment2) {
            strip[0] = strip[elements];
        }
        self.torque[0] = self.torque[elements];
    }

    /// Evaluates eight elements.
    #[inline(always)]
    pub(super) fn add_block<N: Number>(
        &mut self,
        e: &mut ElementBlock,
        state: &State,
        which: Eight,
        input: &StepInput,
        losses: &mut Losses,
    ) {
        let block = which.block;
        let u = nine(&state.u, block);
        let v = nine(&state.v, block);
        let d = nine(&state.d, block);
        let w = nine(&state.w, block);
        let spin = state.spin.nine(block);
        let (dt, beta) = (N::splat(input.dt), N::splat(input.stiffness_damping));
        let mut force = [[0.0; LANES]; 3];
        let mut moment1 = [[0.0; LANES]; 3];
        let mut moment2 = [[0.0; LANES]; 3];
        let (mut twist, mut tension, mut torque, mut damped) =
            ([0.0; LANES], [0.0; LANES], [0.0; LANES], [0.0; LANES]);
        for lane in 0..LANES {
            let next = lane + 1;
            let pose = Pose {
                anchor_chord: at3(&e.chord, lane),
                anchor_excess: at(&e.excess, lane),
                displacement: from::<N, 9>(&u, next) - from(&u, lane),
                velocity: from::<N, 9>(&v, next) - from(&v, lane),
                d1: from(&d, lane),
                d2: from(&d, next),
                w1: from(&w, lane),
                w2: from(&w, next),
                spin: N::splat(spin[next]) - N::splat(spin[lane]),
                twist: at(&e.twist, lane),
            };
            let stiffness = Stiffness {
                length: at(&e.length, lane),
                inverse_length: at(&e.inverse_length, lane),
                axial: at(&e.axial, lane),
                bending_near: at(&e.bending_near, lane),
                bending_far: at(&e.bending_far, lane),
                bow_near: at(&e.bow_near, lane),
                bow_far: at(&e.bow_far, lane),
                twist: at(&e.torsion, lane),
                bending: at(&e.bending, lane),
            };
            let r = react::<N>(&stiffness, &pose, dt, beta);
            twist[lane] = r.twist.get();
            tension[lane] = r.tension.get();
            torque[lane] = r.torque.get();
            put(&mut force, lane, r.force);
            put(&mut moment1, lane, r.moment1);
            put(&mut moment2, lane, r.moment2);
            damped[lane] = r.damping_power.get();
        }
        (e.twist.0, e.tension.0, e.torque.0) = (twist, tension, torque);
        add(&mut losses.damping, &damped);
        // Strips are one element late: place `i + 1` holds element `i`.
        let from = which.place * LANES + 1;
        for axis in 0..3 {
            write_eight(&mut self.force[axis], from, &force[axis]);
            write_eight(&mut self.moment1[axis], from, &moment1[axis]);
            write_eight(&mut self.moment2[axis], from, &moment2[axis]);
        }
        write_eight(&mut self.torque, from, &e.torque.0);
    }
}

/// Eight numbers of a strip from `from` on.
#[inline(always)]
pub(super) fn eight(strip: &Strip, from: usize) -> &[f64; LANES] {
    strip[from..].first_chunk().expect("a strip holds its tile")
}

/// Eight vectors of three strips from `from` on.
#[inline(always)]
pub(super) fn eights(strips: &[Strip; 3], from: usize) -> [&[f64; LANES]; 3] {
    [
        eight(&strips[0], from),
        eight(&strips[1], from),
        eight(&strips[2], from),
    ]
}

/// Writes eight numbers to a strip from `from` on.
#[inline(always)]
fn write_eight(strip: &mut Strip, from: usize, values: &[f64; LANES]) {
    *strip[from..]
        .first_chunk_mut()
        .expect("a strip holds its tile") = *values;
}
