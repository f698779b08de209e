//! Update of the nodes in a step.

use super::{
    elements::Pull,
    lane::{Losses, StepInput, add, at, at3, put, put3},
};
use crate::{
    dynamics::kernel::chain::{NodeBlock, Row, Rows, StateBlock},
    rod::element::across,
    simd::number::{Number, Real},
    wall::{friction, normal_force},
};

/// A row of nodes during the step: the prediction from rod, gravity, mud and damping before the
/// wall's reaction, and the reaction. Computed and used in short loops over the row, so that the
/// processor works on several lanes while it waits for a root or a division.
#[derive(Clone, Copy)]
pub(super) struct Prediction<R: Real> {
    /// Velocity per newton across the hole and along it, m/s, and spin per newton metre about the
    /// director, rad/s.
    pub(super) mobility: Row<R>,
    mobility_axial: Row<R>,
    mobility_spin: Row<R>,
    /// Velocity along the hole at the step's beginning.
    axial0: Row<R>,
    /// Fraction of the velocity along the hole, and of the spin, that viscous mud removes in the
    /// step.
    slowed_axial: Row<R>,
    slowed_spin: Row<R>,
    /// Velocity, its part along the hole, and spin, before the wall acts.
    v: Rows<R>,
    axial: Row<R>,
    spin: Row<R>,
    /// Offset from the hole's axis at the step's end, and the clearance there.
    pub(super) offset: Rows<R>,
    pub(super) clearance: Row<R>,
    /// Speed towards the wall times the distance from the axis.
    pub(super) inward: Row<R>,
    /// The direction of the offset.
    pub(super) normal: Rows<R>,
    /// Contact force, N.
    pub(super) normal_force: Row<R>,
    /// Direction around the hole, and friction along and around it.
    around: Rows<R>,
    friction_along: Row<R>,
    friction_around: Row<R>,
}

impl<R: Real> Prediction<R> {
    pub(super) fn none() -> Self {
        let zero = Row::filled(0.0);
        Self {
            mobility: zero,
            mobility_axial: zero,
            mobility_spin: zero,
            axial0: zero,
            slowed_axial: zero,
            slowed_spin: zero,
            v: [zero; 3],
            axial: zero,
            spin: zero,
            offset: [zero; 3],
            clearance: zero,
            inward: zero,
            normal: [zero; 3],
            normal_force: zero,
            around: [zero; 3],
            friction_along: zero,
            friction_around: zero,
        }
    }
}

/// Kicks a row of nodes: how they would move without a wall.
#[inline(always)]
pub(super) fn predict<N: Number, const FULL: bool>(
    prediction: &mut Prediction<N::Real>,
    n: &NodeBlock<N::Real>,
    state: &StateBlock<N::Real>,
    above: &Pull<N::Real>,
    below: &Pull<N::Real>,
    input: &StepInput,
    lane: usize,
) {
    let dt = N::splat(input.dt);
    let th = at3::<N>(&n.tangent, lane);
    let mobility = dt * at(&n.inv_mass_lateral, lane);
    let mobility_axial = dt * at(&n.inv_mass_axial, lane);
    let mobility_spin = dt * at(&n.inv_polar, lane);
    let (v0, s0) = (at3::<N>(&state.v, lane), at::<N>(&state.spin, lane));
    let axial0 = th.dot(v0);
    // A node is end 2 of the element above it and end 1 of the one below.
    let force = at3::<N>(&above.force, lane) - at3(&below.force, lane) + at3(&n.weight, lane);
    let along = th.dot(force);
    let torque = at::<N>(&below.torque, lane) - at(&above.torque, lane);
    let gained = mobility_axial * along;
    // Drag acts on the node's velocity before the step. It leaves the impulse of rod and gravity
    // unchanged, because a wall or a hoist that cancels it within the step must receive all of it.
    let slowed = at::<N>(&n.slowed, lane);
    let remaining = N::splat(1.0) - slowed;
    // This replaces the axial part as computed with the drag and the mass across the hole.
    let mut instead = slowed.mul_add(axial0, mobility.neg_mul_add(along, gained));
    let mut axial = axial0 + gained;
    let mut spin = mobility_spin.mul_add(torque, s0);
    if FULL {
        let half = N::splat(0.5);
        // An explicit drag that took more than the velocity would turn it round.
        let slowed_axial = (mobility_axial * at(&n.mud_axial, lane)).min(half) * axial0;
        let slowed_spin = (mobility_spin * at(&n.mud_spin, lane)).min(half) * s0;
        (instead, axial) = (instead - slowed_axial, axial - slowed_axial);
        spin = spin - slowed_spin;
        put(&mut prediction.slowed_axial, lane, slowed_axial);
        put(&mut prediction.slowed_spin, lane, slowed_spin);
    }
    let v = v0.scaled(remaining).plus(force, mobility).plus(th, instead);
    put(&mut prediction.mobility, lane, mobility);
    put(&mut prediction.mobility_axial, lane, mobility_axial);
    put(&mut prediction.mobility_spin, lane, mobility_spin);
    put(&mut prediction.axial0, lane, axial0);
    put3(&mut prediction.v, lane, v);
    put(&mut prediction.axial, lane, axial);
    put(&mut prediction.spin, lane, spin);
}

/// Computes the position of a row of nodes against the curved wall at the step's end; returns
/// whether one of them would be inside the wall.
#[inline(always)]
pub(super) fn gap<N: Number, const FULL: bool>(
    prediction: &mut Prediction<N::Real>,
    n: &NodeBlock<N::Real>,
    state: &StateBlock<N::Real>,
    input: &StepInput,
    lane: usize,
) -> bool {
    let (half, dt) = (N::splat(0.5), N::splat(input.dt));
    let th = at3::<N>(&n.tangent, lane);
    let v = at3::<N>(&prediction.v, lane);
    let u = at3::<N>(&state.u, lane).plus(v, dt);
    let z = th.dot(u);
    // offset = u − z T − ½ z² κ: from the curved axis, not from its tangent.
    let offset = u.minus(th, z).minus(at3(&n.curvature, lane), half * (z * z));
    let clearance = if FULL {
        at::<N>(&n.clearance_slope, lane).mul_add(z, at(&n.clearance, lane))
    } else {
        at(&n.clearance, lane)
    };
    put3(&mut prediction.offset, lane, offset);
    put(&mut prediction.clearance, lane, clearance);
    put(&mut prediction.inward, lane, v.dot(offset));
    // |offset|² > clearance²: no root where nothing touches.
    clearance.neg_mul_add(clearance, offset.dot(offset)).any_positive()
}

/// Rubs a row of nodes that are pushed on the wall.
#[inline(always)]
pub(super) fn friction<N: Number, const VECTOR: bool, const FULL: bool>(
    prediction: &mut Prediction<N::Real>,
    n: &NodeBlock<N::Real>,
    input: &StepInput,
    lane: usize,
) {
    let splat = N::splat;
    let per_stribeck2 = splat(1.0 / (input.stribeck_speed * input.stribeck_speed));
    let v = at3::<N>(&prediction.v, lane);
    let (axial, spin) = (at::<N>(&prediction.axial, lane), at::<N>(&prediction.spin, lane));
    let force = at::<N>(&prediction.normal_force, lane);
    let radius = at::<N>(&n.radius, lane);
    let around = at3::<N>(&n.tangent, lane).cross(at3(&prediction.normal, lane));
    // At the surface that touches.
    let slip = radius.mul_add(spin, v.dot(around));
    let mu = if FULL {
        let speed2 = slip.mul_add(slip, axial * axial);
        let rise = at(&n.friction_rise, lane);
        friction::coefficient(at(&n.friction, lane), rise, speed2, per_stribeck2)
    } else {
        at::<N>(&n.friction, lane)
    };
    let limit = force * mu;
    // One newton always takes some speed away: a node that is held everywhere keeps its friction.
    let least = splat(1e-30);
    let g_axial = at::<N>(&prediction.mobility_axial, lane).max(least);
    // dt (1/m_lat + r²/J): rotational friction moves the axis and turns the pipe.
    let g_around = (radius * at(&prediction.mobility_spin, lane))
        .mul_add(radius, at(&prediction.mobility, lane))
        .max(least);
    let limit_around = if FULL { limit * at(&n.friction_around, lane) } else { limit };
    // Vector: Coulomb's cone. Independent: the whole limit along and the whole limit around.
    let (friction_along, friction_around) = match (VECTOR, FULL) {
        (true, false) => friction::vector(limit, axial, slip, g_axial, g_around),
        // In the forces' parts of their limits the law is that of one limit, 1.
        (true, true) => {
            let g_axial = (g_axial * limit).max(least);
            let g_around = (g_around * limit_around).max(least);
            let (a, t) = friction::vector(splat(1.0), axial, slip, g_axial, g_around);
            (limit * a, limit_around * t)
        }
        (false, _) => (
            friction::independent(limit, axial, g_axial),
            friction::independent(limit_around, slip, g_around),
        ),
    };
    put3(&mut prediction.around, lane, around);
    put(&mut prediction.friction_along, lane, friction_along);
    put(&mut prediction.friction_around, lane, friction_around);
}

/// Moves a row of nodes to where the step ends. Where none of them touches the wall, nothing of it
/// is computed.
#[inline(always)]
pub(super) fn correct<N: Number, const FULL: bool, const TOUCHES: bool>(
    prediction: &Prediction<N::Real>,
    n: &mut NodeBlock<N::Real>,
    state: &mut StateBlock<N::Real>,
    input: &StepInput,
    losses: &mut Losses<N::Real>,
    lane: usize,
) {
    let splat = N::splat;
    let dt = splat(input.dt);
    let half_dt = splat(0.5 * input.dt);
    let th = at3::<N>(&n.tangent, lane);
    let mobility = at::<N>(&prediction.mobility, lane);
    let (v0, s0) = (at3::<N>(&state.v, lane), at::<N>(&state.spin, lane));
    let (mut v3, mut s3) = (at3::<N>(&prediction.v, lane), at::<N>(&prediction.spin, lane));
    let mut axial3 = at::<N>(&prediction.axial, lane);
    let axial0 = at::<N>(&prediction.axial0, lane);
    let mut both = v0 + v3;

    // Energy that left the string: every impulse but the rod's and gravity's works on the mean of
    // the velocities before and after the step.
    if TOUCHES {
        let radius = at::<N>(&n.radius, lane);
        let (normal, around) =
            (at3::<N>(&prediction.normal, lane), at3::<N>(&prediction.around, lane));
        let force = at::<N>(&prediction.normal_force, lane);
        let along = at::<N>(&prediction.friction_along, lane);
        let across = at::<N>(&prediction.friction_around, lane);
        let torque = across * radius;
        let stopped = at::<N>(&prediction.mobility_axial, lane) * along;
        axial3 = axial3 - stopped;
        v3 = v3.minus(normal, mobility * force).minus(around, mobility * across).minus(th, stopped);
        s3 = at::<N>(&prediction.mobility_spin, lane).neg_mul_add(torque, s3);
        both = v0 + v3;
        let contact = force * normal.dot(both);
        let slid = radius.mul_add(s0 + s3, around.dot(both));
        let rubbed = half_dt * along.mul_add(axial0 + axial3, across * slid);
        add(&mut n.sum_normal, lane, force);
        add(&mut n.sum_axial, lane, along);
        add(&mut n.sum_torque, lane, torque);
        add(&mut n.sum_wear, lane, rubbed);
        add(&mut losses.contact, lane, contact);
    }
    let both_axial = axial0 + axial3;
    // The drag across the hole took `slowed` of v0 less its part along the hole.
    let drag = at::<N>(&n.mass_lateral, lane) * at(&n.slowed, lane);
    let mut slowed = drag * axial0.neg_mul_add(both_axial, v0.dot(both));
    if FULL {
        let drag_axial = at::<N>(&n.mass_axial, lane) * at(&prediction.slowed_axial, lane);
        let drag_spin = at::<N>(&n.polar, lane) * at(&prediction.slowed_spin, lane);
        slowed = drag_axial.mul_add(both_axial, drag_spin.mul_add(s0 + s3, slowed));
    }
    add(&mut losses.mud, lane, slowed);
    // Positions advance with the new velocity: the drift of the leapfrog.
    let u0 = at3::<N>(&state.u, lane);
    put3(&mut state.u, lane, u0.plus(v3, dt));
    put3(&mut state.v, lane, v3);
    put(&mut state.spin, lane, s3);
}

/// Turns the directors of nodes.
#[inline(always)]
pub(super) fn rotate_directors<N: Number>(
    n: &NodeBlock<N::Real>,
    state: &mut StateBlock<N::Real>,
    above: &Pull<N::Real>,
    below: &Pull<N::Real>,
    input: &StepInput,
    lane: usize,
) {
    let splat = N::splat;
    let (one, dt, half_dt) = (splat(1.0), splat(input.dt), splat(0.5 * input.dt));
    let quarter_dt2 = splat(0.25 * input.dt * input.dt);
    let (d0, w0) = (at3::<N>(&state.d, lane), at3::<N>(&state.w, lane));
    // End 2 of the element above, end 1 of the one below: its couple acts the other way round.
    let moment = across(
        at3::<N>(&above.bend2, lane) + at3(&below.bend1, lane),
        at3::<N>(&below.couple, lane) - at3(&above.couple, lane),
        d0,
    );
    let kick = moment.scaled(half_dt * at(&n.inv_rotary, lane));
    let halfway = w0 + kick;
    // By the tangent of the precession, which lengthens by half its square: `damp` takes that out.
    let precession = dt * at(&n.gyroscopic, lane) * at(&state.spin, lane);
    // Half of the kick precesses, half does not: turned by all of it, the kick would feed whirl, by
    // a quarter of the precession times the angle by which the step advances the whirl.
    let turning = (halfway + kick).minus(halfway.cross(d0), precession);
    let q = quarter_dt2 * turning.dot(turning);
    // 1/(1 + q), but for q⁴: q is the square of half the turn in a step. (1 − q)/(1 + q) is twice
    // that less one.
    let shrink = (one - q) * q.mul_add(q, one);
    let turned = d0.scaled(shrink + shrink - one).plus(turning.cross(d0), dt * shrink);
    put3(&mut state.d, lane, turned);
    put3(&mut state.w, lane, turning);
}

// Contact force of the wall.

/// Contact forces of a row of nodes.
#[inline(always)]
pub(super) fn normal_contact<N: Number, const HERTZ: bool>(
    prediction: &mut Prediction<N::Real>,
    n: &NodeBlock<N::Real>,
    input: &StepInput,
    lane: usize,
) {
    let dt = N::splat(input.dt);
    let offset = at3::<N>(&prediction.offset, lane);
    // The least distance keeps the inverse finite for a node on the axis.
    let distance = (offset.dot(offset) + N::splat(1e-30)).sqrt();
    let inverse = N::splat(1.0) / distance;
    let penetration = distance - at(&prediction.clearance, lane);
    // v·offset/|offset|: the velocity towards the wall.
    let inward = inverse * at(&prediction.inward, lane);
    let stiffness = at(&n.stiffness, lane);
    let mobility = at::<N>(&prediction.mobility, lane);
    let force: N = if HERTZ {
        let dissipation = N::splat(input.dissipation);
        normal_force::hertz(penetration, inward, stiffness, dissipation, dt * mobility)
    } else {
        let damping = at(&n.damping, lane);
        normal_force::linear(penetration, inward, stiffness, damping, mobility, dt)
    };
    put3(&mut prediction.normal, lane, offset.scaled(inverse));
    put(&mut prediction.normal_force, lane, force);
}
