//! Effect of eccentric masses in a step.
//!
//! A row without any is skipped, and so are the registers of a row without any; lanes next to those
//! with one receive zero and keep every digit.

use super::{
    elements::Pull,
    lane::{StepInput, at, at3, put, put3},
};
use crate::{
    dynamics::kernel::chain::{ImbalanceBlock, NodeBlock, Row, Rows, StateBlock},
    rod::imbalance::{self, Direction, Mobility, Motion},
    simd::{
        number::{Number, Real},
        vector::Vector,
    },
};

/// A row of eccentric nodes before the step.
#[derive(Clone, Copy)]
pub(super) struct Before<R: Real> {
    director: Rows<R>,
    velocity: Rows<R>,
    /// [`imbalance::Throw`].
    led: Rows<R>,
}

impl<R: Real> Before<R> {
    pub(super) fn none() -> Self {
        let zero = [Row::filled(0.0); 3];
        Self { director: zero, velocity: zero, led: zero }
    }
}

/// Lets eccentric nodes be thrown outwards and turned by gravity, as if the elements above them
/// pulled so.
#[inline(always)]
pub(super) fn throw<N: Number>(
    above: &mut Pull<N::Real>,
    before: &mut Before<N::Real>,
    imbalances: &ImbalanceBlock<N::Real>,
    state: &StateBlock<N::Real>,
    input: &StepInput,
    lane: usize,
) {
    let moment = at::<N>(&imbalances.moment, lane);
    if !moment.any_positive() {
        return;
    }
    let (d, velocity) = (at3::<N>(&state.d, lane), at3::<N>(&state.v, lane));
    let omega = at3::<N>(&state.w, lane).plus(d, at(&state.spin, lane));
    let (toward, half) = (at3::<N>(&imbalances.toward, lane), at3(&imbalances.half, lane));
    let throw = imbalance::throw(toward, half, omega, N::splat(input.dt));
    let force = at3::<N>(&above.force, lane).plus(throw.outwards, moment);
    put3(&mut above.force, lane, force);
    // U q × g on the node, gravity straight down.
    let weight = at::<N>(&imbalances.weight_moment, lane);
    let [x, y, _] = &mut above.couple;
    put(x, lane, weight.neg_mul_add(toward.1, at(x, lane)));
    put(y, lane, weight.mul_add(toward.0, at(y, lane)));
    let about = toward.1.neg_mul_add(d.0, toward.0 * d.1);
    let torque = weight.mul_add(about, at(&above.torque, lane));
    put(&mut above.torque, lane, torque);
    put3(&mut before.director, lane, d);
    put3(&mut before.velocity, lane, velocity);
    put3(&mut before.led, lane, throw.led);
}

/// Adds the effect of the step's accelerations and advances the directions.
#[inline(always)]
pub(super) fn follow<N: Number>(
    before: &Before<N::Real>,
    imbalances: &mut ImbalanceBlock<N::Real>,
    n: &NodeBlock<N::Real>,
    state: &mut StateBlock<N::Real>,
    input: &StepInput,
    lane: usize,
) {
    let moment = at::<N>(&imbalances.moment, lane);
    if !moment.any_positive() {
        return;
    }
    let dt = N::splat(input.dt);
    let motion = Motion {
        director: at3(&state.d, lane),
        velocity: at3(&state.v, lane),
        turning: at3(&state.w, lane),
        spin: at::<N>(&state.spin, lane),
    };
    let mobility = Mobility {
        tangent: at3(&n.tangent, lane),
        lateral: at(&n.inv_mass_lateral, lane),
        axial: at(&n.inv_mass_axial, lane),
        polar: at(&n.inv_polar, lane),
        rotary: at(&n.inv_rotary, lane),
    };
    let (toward, from) = (at3::<N>(&imbalances.toward, lane), at3(&before.director, lane));
    let turned = imbalance::turned(toward, from, motion.director, motion.spin * dt);
    let (velocity, led) = (at3(&before.velocity, lane), at3(&before.led, lane));
    let change = imbalance::balance(moment, &turned, led, velocity, &motion, &mobility);
    let after = imbalance::changed(&motion, &turned, &change, dt);
    let rest = if N::Real::FINE { Vector::zero() } else { at3(&imbalances.rest, lane) };
    let direction = Direction { toward, rest };
    let carried = imbalance::carried(&direction, &turned, &change, after.director, dt);
    let u = at3::<N>(&state.u, lane).minus(change.slowed, dt);
    put3(&mut state.u, lane, u);
    put3(&mut state.v, lane, after.velocity);
    put3(&mut state.d, lane, after.director);
    put3(&mut state.w, lane, after.turning);
    put(&mut state.spin, lane, after.spin);
    put3(&mut imbalances.toward, lane, carried.toward);
    put3(&mut imbalances.half, lane, turned.half);
    if !N::Real::FINE {
        put3(&mut imbalances.rest, lane, carried.rest);
    }
}
