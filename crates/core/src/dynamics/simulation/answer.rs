//! From a run to its answer, and the samples that it is made of.

use super::run::Run;
use crate::{
    dynamics::{
        boundary::mud::viscous::Viscous,
        output::{
            energy::{self, Energies, EnergyBalance},
            indicators::Indicators,
            outcome::DynamicOutcome,
            summary,
        },
    },
    outcome::{EarlierRows, History},
    simd::number::Real,
};

impl<R: Real> Run<R> {
    /// The answer so far: over the window if it has begun, over everything sampled otherwise.
    pub fn outcome(&self) -> DynamicOutcome {
        summary::outcome(&self.sources(None))
    }

    /// The same with the rows that were handed over.
    pub fn outcome_with(&self, earlier: &dyn EarlierRows) -> DynamicOutcome {
        summary::outcome(&self.sources(Some(earlier)))
    }

    /// The indicators of the outcome so far, without the rest of it.
    pub fn indicators(&self) -> Indicators {
        summary::indicators(&self.sources(None))
    }

    /// Rows of the series that the run itself needs no more.
    pub fn spare_rows(&self) -> usize {
        let needed = match self.state.window_open {
            true => 1,
            false => self.settling.needed_samples(self.sample_interval_s()),
        };
        self.state.record.series.time_s.len().saturating_sub(needed)
    }

    /// Rows that were handed over.
    pub fn handed_over(&self) -> usize {
        self.state.record.handed_over
    }

    /// Drops the first rows of the series, which the caller keeps.
    pub fn hand_over(&mut self, rows: usize) {
        let rows = rows.min(self.spare_rows());
        self.state.record.hand_over(rows);
    }

    fn sources<'a>(&'a self, earlier: Option<&'a dyn EarlierRows>) -> summary::Sources<'a> {
        let diverged = self.check_numbers().is_err();
        let record = &self.state.record;
        let earlier = earlier.filter(|_| record.handed_over > 0);
        let from = match earlier {
            Some(_) => record.window_row,
            None => record.window_row_in_memory(),
        };
        summary::Sources {
            model: &self.model,
            operation: &self.operation,
            mesh: &self.mesh,
            plan: &self.plan,
            anchors: &self.state.anchors,
            record,
            history: History::new(earlier, &record.series),
            from,
            wear: &self.state.wear,
            bit: &self.state.bit,
            steps: self.state.steps,
            energy: self.energy_balance().filter(|_| !diverged),
            diverged,
            hydraulics: self.state.viscous.as_ref().map(Viscous::mean),
            pressures: self.state.viscous.as_ref().map(Viscous::mean_pressures),
            flow_stretches_m: self
                .state
                .viscous
                .as_ref()
                .map(|mud| mud.mean_stretches_m(&self.mesh)),
            instructions: self.stepper.instructions,
            settling: self.settling,
            settled: self.state.settled,
        }
    }
}

// Energy of a run, and where it goes.

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
    fn energy_balance(&self) -> Option<(EnergyBalance, f64)> {
        self.state
            .window_open
            .then(|| {
                let min_J = energy::min_J(&self.mesh);
                self.state.ledger.balance(&self.energies(), self.flow_work_J(), min_J)
            })
            .flatten()
    }
}
