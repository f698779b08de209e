//! Mass-proportional damping: its time scale is long compared with a step, so it acts once in
//! several steps, between two of them. The length that precession has added by then is removed.

use super::lane::{add, at, at3, lanes, put, put3};
use crate::{
    dynamics::kernel::chain::{RegionRows, Row},
    simd::number::{Number, Real},
};

/// Effect of mass-proportional damping over a time.
#[derive(Debug, Clone, Copy)]
pub struct MassDamping {
    /// That time `T`, s.
    pub time_s: f64,
    /// The steps that it is made of, s.
    pub dt: f64,
    /// Remaining fraction of the motion relative to the rigid one: `exp(−αT)`.
    pub left: f64,
    /// Axial velocity of the rigid motion, m/s.
    pub rigid_velocity: f64,
    /// Spin of that motion, rad/s.
    pub rigid_spin: f64,
}

/// Damps all nodes; the energy that it takes, J. That of lateral rotation is a millionth of the
/// whole and not counted.
#[inline(always)]
pub(super) fn damp<N: Number>(region: RegionRows<'_, N::Real>, mass_damping: &MassDamping) -> f64 {
    let splat = N::splat;
    let (zero, one, left) = (N::zero(), splat(1.0), splat(mass_damping.left));
    let lengthening = splat(0.5 * mass_damping.dt * mass_damping.time_s);
    let damped = splat(1.0 - mass_damping.left);
    let (rigid_v, rigid_s) = (splat(mass_damping.rigid_velocity), splat(mass_damping.rigid_spin));
    let mut taken: Row<N::Real> = Row::filled(0.0);
    for (n, state) in region.node_blocks.iter().zip(region.states) {
        for lane in lanes::<N>() {
            let th = at3::<N>(&n.tangent, lane);
            let (v0, s0) = (at3::<N>(&state.v, lane), at::<N>(&state.spin, lane));
            let axial0 = th.dot(v0);
            // Padding in the last lane stays in place.
            let free = at::<N>(&n.inv_mass_axial, lane).if_positive(damped, zero);
            // Along the hole and about the axis only the motion in excess of the rigid one decays,
            // across it all motion.
            let axial1 = free.neg_mul_add(axial0 - rigid_v, axial0);
            let v1 = v0.scaled(left).plus(th, left.neg_mul_add(axial0, axial1));
            let free = at::<N>(&n.inv_polar, lane).if_positive(damped, zero);
            let s1 = free.neg_mul_add(s0 - rigid_s, s0);
            // Squares before less squares after.
            let along = (axial0 - axial1) * (axial0 + axial1);
            let across = (v0 - v1).dot(v0 + v1) - along;
            let about = (s0 - s1) * (s0 + s1);
            let lost = at::<N>(&n.mass_lateral, lane).mul_add(
                across,
                at::<N>(&n.mass_axial, lane).mul_add(along, at::<N>(&n.polar, lane) * about),
            );
            add(&mut taken, lane, lost);
            put3(&mut state.v, lane, v1);
            put(&mut state.spin, lane, s1);
            // (1 + P²)^½ for each step, P the precession in it.
            let precession = at::<N>(&n.gyroscopic, lane) * s0;
            let longer = (lengthening * precession).mul_add(precession, one);
            let w = at3::<N>(&state.w, lane);
            put3(&mut state.w, lane, w.scaled(left / longer));
        }
    }
    0.5 * taken.0.as_ref().iter().map(|x| x.to_f64()).sum::<f64>()
}
