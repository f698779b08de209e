//! What a step does to the nodes.

use super::{
    Losses, StepInput,
    elements::{Pull, eight, eights},
    lane::{Eight, add, at, at3, from, held, nine, put},
};
use crate::{
    dynamics::chain::{NodeBlock, State},
    rod::{lanes::LANES, number::Number},
    wall::friction,
};

/// How eight nodes would meet the wall at the end of the step.
pub(super) struct Approach {
    /// Penetration, m.
    pub(super) penetration: [f64; LANES],
    /// Speed towards the wall, m/s.
    pub(super) inward: [f64; LANES],
}

/// Eight nodes on their way: what the rod, gravity, mud and damping make of the step before the wall
/// has its say. A tile is flown, then pushed, then landed: short loops over neighbours, so that the
/// processor works on several while it waits for a division.
#[derive(Clone, Copy)]
pub(super) struct Flight {
    /// Velocity across the hole and along it, and spin, at the step's beginning.
    across0: [[f64; LANES]; 3],
    axial0: [f64; LANES],
    spin0: [f64; LANES],
    /// After the kick by the rod and by gravity.
    across1: [[f64; LANES]; 3],
    axial1: [f64; LANES],
    spin1: [f64; LANES],
    /// After mud drag and mass-proportional damping.
    across2: [[f64; LANES]; 3],
    axial2: [f64; LANES],
    spin2: [f64; LANES],
    /// Direction from the axis where the step would end.
    normal: [[f64; LANES]; 3],
}

impl Flight {
    pub(super) const NONE: Self = Self {
        across0: [[0.0; LANES]; 3],
        axial0: [0.0; LANES],
        spin0: [0.0; LANES],
        across1: [[0.0; LANES]; 3],
        axial1: [0.0; LANES],
        spin1: [0.0; LANES],
        across2: [[0.0; LANES]; 3],
        axial2: [0.0; LANES],
        spin2: [0.0; LANES],
        normal: [[0.0; LANES]; 3],
    };

    /// Kicks eight nodes and lets them fly to where the step would end without a wall.
    #[inline(always)]
    pub(super) fn fly<N: Number, const FULL: bool>(
        &mut self,
        n: &NodeBlock,
        state: &State,
        which: Eight,
        input: &StepInput,
        pull: &Pull,
    ) -> Approach {
        let block = which.block;
        let above = which.place * LANES;
        let below = above + 1;
        let force_above = eights(&pull.force, above);
        let force_below = eights(&pull.force, below);
        let torque_above = eight(&pull.torque, above);
        let torque_below = eight(&pull.torque, below);
        let (u, v) = (nine(&state.u, block), nine(&state.v, block));
        let spin = state.spin.nine(block);
        let splat = N::splat;
        let (half, dt) = (splat(0.5), splat(input.dt));
        let alpha = splat(input.mass_damping);
        let fade = (alpha * dt).min(half);
        let (rigid_v, rigid_s) = (splat(input.rigid_velocity), splat(input.rigid_spin));
        let (mut penetration, mut inward) = ([0.0; LANES], [0.0; LANES]);
        for lane in 0..LANES {
            // Kick by the rod and by gravity, along the hole and across it.
            let force =
                from::<N, 8>(&force_above, lane) - from(&force_below, lane) + at3(&n.weight, lane);
            let torque = splat(torque_below[lane]) - splat(torque_above[lane]);
            let th = at3::<N>(&n.tangent, lane);
            let per_ml = at::<N>(&n.inv_mass_lateral, lane);
            let per_j = at::<N>(&n.inv_polar, lane);
            let (v0, s0) = (from::<N, 9>(&v, lane), splat(spin[lane]));
            let along = th.dot(force);
            let axial0 = th.dot(v0);
            let across0 = v0.minus(th, axial0);
            let axial1 = (dt * at(&n.inv_mass_axial, lane)).mul_add(along, axial0);
            let across1 = across0.plus(force.minus(th, along), dt * per_ml);
            let s1 = (dt * per_j).mul_add(torque, s0);

            // Mud drag and mass-proportional damping of the velocity that the node came with. The kick is
            // left whole: a wall or a hoist that takes it back within the step must feel all of it.
            let speed = across0.dot(across0).sqrt();
            let drag = at::<N>(&n.drag_quadratic, lane).mul_add(speed, at(&n.drag_linear, lane));
            // A hundredth in any mud; a brake still at any speed.
            let slowed = (per_ml.mul_add(drag, alpha) * dt).min(half);
            let mut axial2 = fade.neg_mul_add(axial0 - rigid_v, axial1);
            let across2 = across1.minus(across0, slowed);
            let fade_spin = per_j.if_positive(fade, N::zero());
            let mut s2 = fade_spin.neg_mul_add(s0 - rigid_s, s1);
            if FULL {
                let per_ma = at::<N>(&n.inv_mass_axial, lane);
                let slowed = (dt * per_ma * at(&n.mud_axial, lane)).min(half);
                axial2 = slowed.neg_mul_add(axial0, axial2);
                let slowed = (dt * per_j * at(&n.mud_spin, lane)).min(half);
                s2 = slowed.neg_mul_add(s0, s2);
            }

            // Where the step would end, against the curved wall.
            let u0 = from::<N, 9>(&u, lane);
            let z0 = th.dot(u0);
            let z = dt.mul_add(axial2, z0);
            let offset = u0
                .minus(th, z0)
                .plus(across2, dt)
                .minus(at3(&n.curvature, lane), half * (z * z));
            let rho = (offset.dot(offset) + splat(1e-30)).sqrt();
            let normal = offset.scaled(splat(1.0) / rho);

            put(&mut self.across0, lane, across0);
            self.axial0[lane] = axial0.get();
            self.spin0[lane] = s0.get();
            put(&mut self.across1, lane, across1);
            self.axial1[lane] = axial1.get();
            self.spin1[lane] = s1.get();
            put(&mut self.across2, lane, across2);
            self.axial2[lane] = axial2.get();
            self.spin2[lane] = s2.get();
            put(&mut self.normal, lane, normal);
            let clearance = if FULL {
                at::<N>(&n.clearance_slope, lane).mul_add(z, at(&n.clearance, lane))
            } else {
                at(&n.clearance, lane)
            };
            penetration[lane] = (rho - clearance).get();
            inward[lane] = across2.dot(normal).get();
        }
        Approach {
            penetration,
            inward,
        }
    }

    /// Lets the wall push and rub, and moves eight nodes to where the step ends.
    #[inline(always)]
    pub(super) fn land<N: Number, const VECTOR: bool, const FULL: bool>(
        &self,
        n: &mut NodeBlock,
        state: &mut State,
        block: usize,
        push: &[f64; LANES],
        input: &StepInput,
        losses: &mut Losses,
    ) {
        let splat = N::splat;
        let (half, dt) = (splat(0.5), splat(input.dt));
        let per_stribeck2 = splat(1.0 / (input.stribeck_speed * input.stribeck_speed));
        let old = nine(&state.u, block);
        let (mut u, mut v) = ([[0.0; LANES]; 3], [[0.0; LANES]; 3]);
        let mut spin = [0.0; LANES];
        let (mut rub_axial, mut rub_torque) = ([0.0; LANES], [0.0; LANES]);
        let mut lost = [[0.0; LANES]; 3];
        for lane in 0..LANES {
            let th = at3::<N>(&n.tangent, lane);
            let per_ma = at::<N>(&n.inv_mass_axial, lane);
            let per_j = at::<N>(&n.inv_polar, lane);
            let mobility = dt * at(&n.inv_mass_lateral, lane);
            let across2 = held::<N>(&self.across2, lane);
            let (axial2, s2) = (splat(self.axial2[lane]), splat(self.spin2[lane]));
            let normal = held::<N>(&self.normal, lane);
            let force = splat(push[lane]);

            // Friction at the surface that touches.
            let around = th.cross(normal);
            let radius = at::<N>(&n.radius, lane);
            let slip = radius.mul_add(s2, across2.dot(around));
            let mu = if FULL {
                let speed2 = slip.mul_add(slip, axial2 * axial2);
                let rise = at(&n.friction_rise, lane);
                friction::coefficient(at(&n.friction, lane), rise, speed2, per_stribeck2)
            } else {
                at::<N>(&n.friction, lane)
            };
            let limit = force * mu;
            // One newton always takes some speed away: a node that is held everywhere keeps its friction.
            let least = splat(1e-30);
            let g_axial = (dt * per_ma).max(least);
            let g_around = (dt * radius * radius).mul_add(per_j, mobility).max(least);
            let limit_around = if FULL {
                limit * at(&n.friction_around, lane)
            } else {
                limit
            };
            let (along, across) = match (VECTOR, FULL) {
                (true, false) => friction::vector(limit, axial2, slip, g_axial, g_around),
                // In the forces' parts of their limits the law is that of one limit, 1.
                (true, true) => {
                    let g_axial = (g_axial * limit).max(least);
                    let g_around = (g_around * limit_around).max(least);
                    let (a, t) = friction::vector(splat(1.0), axial2, slip, g_axial, g_around);
                    (limit * a, limit_around * t)
                }
                (false, _) => (
                    friction::independent(limit, axial2, g_axial),
                    friction::independent(limit_around, slip, g_around),
                ),
            };
            let torque = across * radius;
            let axial3 = (dt * per_ma).neg_mul_add(along, axial2);
            let across3 = across2
                .minus(normal, mobility * force)
                .minus(around, mobility * across);
            let v3 = across3.plus(th, axial3);
            let s3 = (dt * per_j).neg_mul_add(torque, s2);

            // Energy that left the string: every impulse but the rod's and gravity's works on the mean of
            // the velocities before and after the step.
            let (across1, axial1) = (held::<N>(&self.across1, lane), splat(self.axial1[lane]));
            let (across0, axial0) = (held::<N>(&self.across0, lane), splat(self.axial0[lane]));
            let (s0, s1) = (splat(self.spin0[lane]), splat(self.spin1[lane]));
            let (both, both_axial, both_spin) = (across0 + across3, axial0 + axial3, s0 + s3);
            let half_dt = half * dt;
            let contact = half_dt * force * normal.dot(both);
            let rubbed = half_dt
                * along.mul_add(
                    both_axial,
                    across.mul_add(around.dot(both), torque * both_spin),
                );
            let slowed = half
                * (at::<N>(&n.mass_lateral, lane) * (across1 - across2).dot(both)
                    + (at::<N>(&n.mass_axial, lane) * (axial1 - axial2))
                        .mul_add(both_axial, at::<N>(&n.polar, lane) * (s1 - s2) * both_spin));

            put(&mut u, lane, from::<N, 9>(&old, lane).plus(v3, dt));
            put(&mut v, lane, v3);
            spin[lane] = s3.get();
            rub_axial[lane] = along.get();
            rub_torque[lane] = torque.get();
            lost[0][lane] = rubbed.get();
            lost[1][lane] = contact.get();
            lost[2][lane] = slowed.get();
        }
        for axis in 0..3 {
            *state.u[axis].eight(block) = u[axis];
            *state.v[axis].eight(block) = v[axis];
        }
        *state.spin.eight(block) = spin;
        add(&mut n.sum_normal.0, push);
        add(&mut n.sum_axial.0, &rub_axial);
        add(&mut n.sum_torque.0, &rub_torque);
        add(&mut n.sum_wear.0, &lost[0]);
        add(&mut losses.friction, &lost[0]);
        add(&mut losses.contact, &lost[1]);
        add(&mut losses.mud, &lost[2]);
    }
}

/// Turns the directors of eight nodes.
#[inline(always)]
pub(super) fn turn<N: Number>(
    n: &NodeBlock,
    state: &mut State,
    which: Eight,
    input: &StepInput,
    pull: &Pull,
) {
    let above = which.place * LANES;
    let block = which.block;
    let moment_above = eights(&pull.moment2, above);
    let moment_below = eights(&pull.moment1, above + 1);
    let splat = N::splat;
    let (one, half, dt) = (splat(1.0), splat(0.5), splat(input.dt));
    // The energy of lateral rotation is a millionth of the whole: its damping is not booked.
    let calm = splat(1.0 - (input.dt * input.mass_damping).min(0.5));
    let (old_d, old_w) = (nine(&state.d, block), nine(&state.w, block));
    let spin = state.spin.nine(block);
    let (mut d, mut w) = ([[0.0; LANES]; 3], [[0.0; LANES]; 3]);
    for lane in 0..LANES {
        let (d0, w0) = (from::<N, 9>(&old_d, lane), from::<N, 9>(&old_w, lane));
        let moment = from::<N, 8>(&moment_above, lane) + from(&moment_below, lane);
        let kick = moment.scaled(half * dt * at(&n.inv_rotary, lane));
        let halfway = w0.scaled(calm) + kick;
        let p = half * dt * at(&n.gyroscopic, lane) * splat(spin[lane]);
        // Cayley's rotation by the precession: (1 − p²)/(1 + p²) and 2p/(1 + p²), to the fifth power of p, half
        // the precession in a step; what is left out brakes by 2p⁶.
        let p2 = p * p;
        let sine = (p + p) * (one - p2);
        let cosine = (p2 + p2).mul_add(p2 - one, one);
        // Half of the kick precesses, half does not: turned by all of it, the kick would feed whirl, by a
        // quarter of the precession times the angle by which the step advances the whirl.
        let turning = halfway.scaled(cosine).minus(halfway.cross(d0), sine) + kick;
        let q = splat(0.25 * input.dt * input.dt) * turning.dot(turning);
        // 1/(1 + q) to rounding: q is the square of half the turn in a step.
        let q2 = q * q;
        let shrink = (one - q).mul_add(one + q2, q2 * q2);
        let turned = d0
            .scaled((one - q) * shrink)
            .plus(turning.cross(d0), dt * shrink);
        put(&mut d, lane, turned);
        put(&mut w, lane, turning);
    }
    for axis in 0..3 {
        *state.d[axis].eight(block) = d[axis];
        *state.w[axis].eight(block) = w[axis];
    }
}
