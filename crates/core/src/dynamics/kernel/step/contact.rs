//! Contact force of the wall.

use super::{
    input::StepInput,
    lane::{at, at3, put, put3},
    nodes::Prediction,
};
use crate::{dynamics::kernel::chain::NodeBlock, simd::number::Number, wall::normal_force};

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
