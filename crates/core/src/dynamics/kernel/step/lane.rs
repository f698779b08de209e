//! Lanes of a row, inputs of a step that are the same for all nodes, and energies that left the
//! string in it.

use crate::{
    dynamics::kernel::chain::{Row, Rows},
    simd::{
        number::{Number, Real},
        vector::Vector,
    },
};

/// First lane of each register of a row.
#[inline(always)]
pub(super) fn lanes<N: Number>() -> impl Iterator<Item = usize> {
    (0..N::Real::LANES).step_by(N::WIDTH)
}

#[inline(always)]
pub(super) fn at<N: Number>(row: &Row<N::Real>, lane: usize) -> N {
    assert!(lane + N::WIDTH <= N::Real::LANES);
    // SAFETY: the row holds so many numbers.
    unsafe { N::load(row.0.as_ref().as_ptr().add(lane)) }
}

#[inline(always)]
pub(super) fn at3<N: Number>(rows: &Rows<N::Real>, lane: usize) -> Vector<N> {
    Vector(at(&rows[0], lane), at(&rows[1], lane), at(&rows[2], lane))
}

#[inline(always)]
pub(super) fn put<N: Number>(row: &mut Row<N::Real>, lane: usize, value: N) {
    assert!(lane + N::WIDTH <= N::Real::LANES);
    // SAFETY: the row holds so many numbers.
    unsafe { value.store(row.0.as_mut().as_mut_ptr().add(lane)) }
}

#[inline(always)]
pub(super) fn put3<N: Number>(rows: &mut Rows<N::Real>, lane: usize, v: Vector<N>) {
    let [x, y, z] = rows;
    put(x, lane, v.0);
    put(y, lane, v.1);
    put(z, lane, v.2);
}

#[inline(always)]
pub(super) fn add<N: Number>(row: &mut Row<N::Real>, lane: usize, value: N) {
    put(row, lane, at::<N>(row, lane) + value);
}

// Inputs that are the same for all nodes in a step.

/// Inputs that are the same for all nodes in a step.
#[derive(Debug, Clone, Copy)]
pub struct StepInput {
    /// Step, s.
    pub dt: f64,
    /// Stiffness-proportional damping, s.
    pub stiffness_damping: f64,
    /// Hunt-Crossley dissipation of the Hertz law, s/m.
    pub dissipation: f64,
    /// Sliding speed at which the friction at rest has half decayed to the kinetic one, m/s.
    pub stribeck_speed: f64,
}

// Energies that left the string in a step.

/// Energies that left the string in a step, J. The losses to wall friction are summed with the
/// nodes.
#[derive(Debug, Clone, Copy, Default)]
pub struct StepLosses {
    /// To the wall's contact forces.
    pub contact: f64,
    /// To the mud; mass-proportional damping is booked with it.
    pub mud: f64,
    /// To stiffness-proportional damping.
    pub damping: f64,
}

impl std::ops::AddAssign for StepLosses {
    fn add_assign(&mut self, other: Self) {
        self.contact += other.contact;
        self.mud += other.mud;
        self.damping += other.damping;
    }
}

/// Energy lost by each lane: the contact's over half the step, twice the mud's in J, the damping's
/// power in W.
pub(super) struct Losses<R: Real> {
    pub(super) contact: Row<R>,
    pub(super) mud: Row<R>,
    pub(super) damping: Row<R>,
}

impl<R: Real> Losses<R> {
    pub(super) fn none() -> Self {
        let zero = Row::filled(0.0);
        Self { contact: zero, mud: zero, damping: zero }
    }
}
