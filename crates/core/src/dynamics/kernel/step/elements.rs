//! Forces and moments of the elements on their ends.

use super::lane::{Losses, StepInput, add, at, at3, put, put3};
use crate::{
    dynamics::kernel::chain::{ElementBlock, Row, Rows, StateBlock},
    rod::element::{self, Chord, Pose, Stiffness, Strain},
    simd::number::{Number, Real},
};

/// Forces and moments of a row of elements on its ends, named as in
/// [`crate::rod::element::Reaction`].
#[derive(Clone, Copy)]
pub(super) struct Pull<R: Real> {
    pub(super) force: Rows<R>,
    pub(super) bend1: Rows<R>,
    pub(super) bend2: Rows<R>,
    pub(super) couple: Rows<R>,
    pub(super) torque: Row<R>,
}

impl<R: Real> Pull<R> {
    pub(super) fn none() -> Self {
        let zero = Row::filled(0.0);
        Self {
            force: [zero; 3],
            bend1: [zero; 3],
            bend2: [zero; 3],
            couple: [zero; 3],
            torque: zero,
        }
    }

    /// Reaction of the last row on the first, where one piece ends and the next begins: each lane's
    /// goes to the next higher lane.
    #[inline(always)]
    pub(super) fn follow_in_lanes(&mut self, last: &Self) {
        let Self { force, bend1: _, bend2, couple, torque } = self;
        for axis in 0..3 {
            force[axis].follow_in_lanes(&last.force[axis]);
            bend2[axis].follow_in_lanes(&last.bend2[axis]);
            couple[axis].follow_in_lanes(&last.couple[axis]);
        }
        torque.follow_in_lanes(&last.torque);
    }
}

/// Chords and strains of a row of elements.
#[derive(Clone, Copy)]
pub(super) struct Strains<R: Real> {
    direction: Rows<R>,
    inverse_length: Row<R>,
    longer: Row<R>,
    apart: Row<R>,
    near1: Row<R>,
    near2: Row<R>,
    shared: Row<R>,
    along: Row<R>,
}

impl<R: Real> Strains<R> {
    pub(super) fn none() -> Self {
        let zero = Row::filled(0.0);
        Self {
            direction: [zero; 3],
            inverse_length: zero,
            longer: zero,
            apart: zero,
            near1: zero,
            near2: zero,
            shared: zero,
            along: zero,
        }
    }

    #[inline(always)]
    fn chord<N: Number<Real = R>>(&self, lane: usize) -> Chord<N> {
        Chord {
            direction: at3(&self.direction, lane),
            inverse_length: at(&self.inverse_length, lane),
            longer: at(&self.longer, lane),
        }
    }
}

/// Finds the chords of elements.
#[inline(always)]
pub(super) fn chord<N: Number>(
    strains: &mut Strains<N::Real>,
    e: &ElementBlock<N::Real>,
    [above, below]: &[StateBlock<N::Real>; 2],
    lane: usize,
) {
    let pose = pose::<N>(e, above, below, lane);
    let c = element::chord::<N>(&stiffness(e, lane), &pose);
    put3(&mut strains.direction, lane, c.direction);
    put(&mut strains.inverse_length, lane, c.inverse_length);
    put(&mut strains.longer, lane, c.longer);
}

/// Twists elements.
#[inline(always)]
pub(super) fn twist<N: Number>(
    out: &mut Pull<N::Real>,
    strains: &mut Strains<N::Real>,
    e: &mut ElementBlock<N::Real>,
    [above, below]: &[StateBlock<N::Real>; 2],
    input: &StepInput,
    losses: &mut Losses<N::Real>,
    lane: usize,
) {
    let (dt, beta) = (N::splat(input.dt), N::splat(input.stiffness_damping));
    let k = stiffness(e, lane);
    let pose = pose::<N>(e, above, below, lane);
    let r = element::twist(&k, &pose, dt, beta);
    put3(&mut out.couple, lane, r.couple);
    put(&mut out.torque, lane, r.torque);
    put(&mut e.torque, lane, r.torque);
    put(&mut e.twist, lane, r.twist);
    put(&mut strains.apart, lane, r.apart);
    add(&mut losses.damping, lane, r.damping_power);
}

/// Strains elements whose chords and twist are known.
#[inline(always)]
pub(super) fn strain<N: Number>(
    strains: &mut Strains<N::Real>,
    e: &mut ElementBlock<N::Real>,
    [above, below]: &[StateBlock<N::Real>; 2],
    input: &StepInput,
    losses: &mut Losses<N::Real>,
    lane: usize,
) {
    let beta = N::splat(input.stiffness_damping);
    let (k, pose) = (stiffness(e, lane), pose::<N>(e, above, below, lane));
    let apart = at(&strains.apart, lane);
    let r = element::strain(&k, &strains.chord(lane), &pose, apart, beta);
    put(&mut strains.near1, lane, r.strain.near1);
    put(&mut strains.near2, lane, r.strain.near2);
    put(&mut strains.shared, lane, r.strain.shared);
    put(&mut strains.along, lane, r.strain.along);
    put(&mut e.tension, lane, r.tension);
    add(&mut losses.damping, lane, r.damping_power);
}

/// Lets elements whose strains are known pull at their ends.
#[inline(always)]
pub(super) fn bend<N: Number>(
    out: &mut Pull<N::Real>,
    strains: &Strains<N::Real>,
    e: &ElementBlock<N::Real>,
    [above, below]: &[StateBlock<N::Real>; 2],
    lane: usize,
) {
    let strain = Strain {
        near1: at(&strains.near1, lane),
        near2: at(&strains.near2, lane),
        shared: at(&strains.shared, lane),
        along: at(&strains.along, lane),
    };
    let pose = pose::<N>(e, above, below, lane);
    let r = element::bend(&strains.chord(lane), &pose, &strain);
    put3(&mut out.force, lane, r.force);
    put3(&mut out.bend1, lane, r.bend1);
    put3(&mut out.bend2, lane, r.bend2);
}

#[inline(always)]
fn stiffness<N: Number>(e: &ElementBlock<N::Real>, lane: usize) -> Stiffness<N> {
    Stiffness {
        length: at(&e.length, lane),
        axial: at(&e.axial, lane),
        bending_far: at(&e.bending_far, lane),
        half_bow_near: at(&e.half_bow_near, lane),
        bow_far: at(&e.bow_far, lane),
        twist: at(&e.torsion, lane),
        bending: at(&e.bending, lane),
    }
}

#[inline(always)]
fn pose<N: Number>(
    e: &ElementBlock<N::Real>,
    above: &StateBlock<N::Real>,
    below: &StateBlock<N::Real>,
    lane: usize,
) -> Pose<N> {
    Pose {
        anchor_chord: at3(&e.chord, lane),
        anchor_excess: at(&e.excess, lane),
        // Differences of the ends: an element knows no absolute position.
        displacement: at3::<N>(&below.u, lane) - at3(&above.u, lane),
        velocity: at3::<N>(&below.v, lane) - at3(&above.v, lane),
        d1: at3(&above.d, lane),
        d2: at3(&below.d, lane),
        w1: at3(&above.w, lane),
        w2: at3(&below.w, lane),
        spin: at::<N>(&below.spin, lane) - at(&above.spin, lane),
        twist: at(&e.twist, lane),
    }
}
