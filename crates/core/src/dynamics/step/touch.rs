//! How the wall pushes back.

use super::{StepInput, TILE, nodes::Approach};
use crate::{
    dynamics::chain::NodeBlock,
    rod::{lanes::LANES, number::Number},
    wall::contact,
};

/// What decides the contact forces of a tile, in one piece.
pub(super) struct Touch {
    /// Penetration where the step would end, m.
    penetration: [f64; TILE * LANES],
    /// Speed towards the wall, m/s.
    inward: [f64; TILE * LANES],
    /// Contact stiffness.
    stiffness: [f64; TILE * LANES],
    /// Damping of the linear law, N·s/m.
    damping: [f64; TILE * LANES],
    /// Lateral mass, kg.
    mass: [f64; TILE * LANES],
    /// Contact force, N.
    push: [f64; TILE * LANES],
}

impl Touch {
    pub(super) const NONE: Self = Self {
        penetration: [0.0; TILE * LANES],
        inward: [0.0; TILE * LANES],
        stiffness: [0.0; TILE * LANES],
        damping: [0.0; TILE * LANES],
        mass: [1.0; TILE * LANES],
        push: [0.0; TILE * LANES],
    };

    /// Contact forces of the tile.
    #[inline(always)]
    pub(super) fn push<N: Number, const HERTZ: bool>(&mut self, input: &StepInput) {
        let splat = N::splat;
        let per_dt2 = splat(1.0 / (input.dt * input.dt));
        for i in 0..TILE * LANES {
            let penetration = splat(self.penetration[i]);
            let inward = splat(self.inward[i]);
            let stiffness = splat(self.stiffness[i]);
            let mass = splat(self.mass[i]);
            let force = if HERTZ {
                let inertia = mass * per_dt2;
                contact::hertz(
                    penetration,
                    inward,
                    stiffness,
                    splat(input.dissipation),
                    inertia,
                )
            } else {
                let damping = splat(self.damping[i]);
                let dt = splat(input.dt);
                contact::linear(penetration, inward, stiffness, damping, mass, dt)
            };
            self.push[i] = force.get();
        }
    }

    /// Takes up how the eight nodes at `place` would meet the wall.
    #[inline(always)]
    pub(super) fn expect(&mut self, n: &NodeBlock, place: usize, approach: &Approach) {
        let lanes = place * LANES..(place + 1) * LANES;
        self.penetration[lanes.clone()].copy_from_slice(&approach.penetration);
        self.inward[lanes.clone()].copy_from_slice(&approach.inward);
        self.stiffness[lanes.clone()].copy_from_slice(&n.stiffness.0);
        self.damping[lanes.clone()].copy_from_slice(&n.damping.0);
        self.mass[lanes].copy_from_slice(&n.mass_lateral.0);
    }

    /// Contact forces of the eight nodes at `place`.
    #[inline(always)]
    pub(super) fn pushes(&self, place: usize) -> &[f64; LANES] {
        self.push[place * LANES..]
            .first_chunk()
            .expect("a tile holds its blocks")
    }
}
