//! How the wall pushes back.

use super::{
    input::StepInput,
    lane::{at, at3, put, put3},
    nodes::Flight,
};
use crate::{dynamics::kernel::chain::NodeBlock, simd::number::Number, wall::contact};

/// Contact forces of a row of nodes.
#[inline(always)]
pub(super) fn push<N: Number, const HERTZ: bool>(
    flight: &mut Flight<N::Real>,
    n: &NodeBlock<N::Real>,
    input: &StepInput,
    lane: usize,
) {
    let dt = N::splat(input.dt);
    let offset = at3::<N>(&flight.offset, lane);
    let distance = (offset.dot(offset) + N::splat(1e-30)).sqrt();
    let inverse = N::splat(1.0) / distance;
    let penetration = distance - at(&flight.clearance, lane);
    let inward = inverse * at(&flight.inward, lane);
    let stiffness = at(&n.stiffness, lane);
    let mobility = at::<N>(&flight.give, lane);
    let force: N = if HERTZ {
        let dissipation = N::splat(input.dissipation);
        contact::hertz(penetration, inward, stiffness, dissipation, dt * mobility)
    } else {
        let damping = at(&n.damping, lane);
        contact::linear(penetration, inward, stiffness, damping, mobility, dt)
    };
    put3(&mut flight.normal, lane, offset.scaled(inverse));
    put(&mut flight.push, lane, force);
}
