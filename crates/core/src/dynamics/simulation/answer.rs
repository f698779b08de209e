//! From a run to its answer, and the samples that it is made of.

use super::run::Run;
use crate::{
    dynamics::{
        boundary::mud::viscous::Viscous,
        output::{indicators::Indicators, outcome::DynamicOutcome, summary},
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
