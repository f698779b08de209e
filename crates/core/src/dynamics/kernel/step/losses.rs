//! Energies that left the string in a step.

use crate::{dynamics::kernel::chain::Row, simd::number::Real};

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
