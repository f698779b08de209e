//! Energy of a run, and where it goes.

use super::run::Run;
use crate::{
    dynamics::{
        boundary::mud::viscous::Viscous,
        output::energy::{self, Energies, EnergyBalance},
    },
    simd::number::Real,
};

impl<R: Real> Run<R> {
    /// Kinetic, elastic and potential energy of the string, J: second-order accurate in the step.
    pub fn energy_J(&self) -> f64 {
        self.energies().total()
    }

    /// Kinetic energy of the string, J.
    pub fn kinetic_energy_J(&self) -> f64 {
        energy::kinetic_J(&self.chain)
    }

    pub(super) fn energies(&self) -> Energies {
        let viscous = self.state.viscous.as_ref();
        Energies::of(&self.chain, &self.state.anchors, &self.state.body, viscous, self.plan.dt_s)
    }

    pub(super) fn flow_work_J(&self) -> f64 {
        let (chain, anchors) = (&self.chain, &self.state.anchors);
        let work = |mud: &Viscous| mud.pull_work_J(chain, anchors, self.plan.dt_s);
        self.state.viscous.as_ref().map_or(0.0, work)
    }

    /// Sources and sinks of energy since the window began, and the relative residual; none before
    /// it begins, and none for a run that diverged.
    pub(super) fn energy_balance(&self) -> Option<(EnergyBalance, f64)> {
        self.state
            .window_open
            .then(|| {
                let min_J = energy::min_J(&self.mesh);
                self.state.ledger.balance(&self.energies(), self.flow_work_J(), min_J)
            })
            .flatten()
    }
}
