//! A bit alone on the rock, tried under one weight at one speed.

mod outcome;
mod response;
mod spec;

use std::f64::consts::PI;

use serde::{Deserialize, Serialize};

use self::outcome::Count;
pub use self::{
    outcome::TrialOutcome,
    response::DrillingResponse,
    spec::{TrialError, TrialSpec},
};
use wholestring_numbers::damage::{Damaged, ensure};

use super::{
    drilling::{Drilling, DrillingSpec},
    executor::Executor,
    kernel::Stepper,
};

/// Samples of the rock's energies in a revolution: each costs as much as a few steps.
const SAMPLES_PER_REVOLUTION: u64 = 8;

/// A trial under way: the bit is held to the hole's axis and turned at a constant speed under a
/// constant weight, first until it has made its bottom, then for the count.
///
/// It is plain data: one that is stored and resumed gives the same bits. It ends after its
/// revolutions, whether the bit advances or not.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Trial {
    spec: TrialSpec,
    drilling: Drilling,
    /// Steps taken.
    steps: u64,
    count: Count,
}

impl Trial {
    /// A bit on its rock before the first step.
    ///
    /// # Errors
    /// A bit that cannot drill the rock, or numbers out of range.
    pub fn new(spec: &TrialSpec, drilling: &DrillingSpec) -> Result<Self, TrialError> {
        spec.check()?;
        Ok(Self {
            spec: *spec,
            drilling: Drilling::new(drilling)?,
            steps: 0,
            count: Count::default(),
        })
    }

    /// Whether a stored trial is this one of this bit.
    ///
    /// # Errors
    /// The part that does not match.
    pub fn check(&self, spec: &TrialSpec, drilling: &DrillingSpec) -> Result<(), Damaged> {
        ensure(self.spec == *spec, "the trial")?;
        self.drilling.check(drilling)
    }

    /// Takes at most this number of steps, as long as any are left. The division into calls does
    /// not matter: the same steps give the same bits.
    ///
    /// # Errors
    /// Forces that are not finite.
    pub fn advance(
        &mut self,
        steps: u64,
        stepper: &Stepper,
        executor: &impl Executor,
    ) -> Result<(), TrialError> {
        let (driver, dt) = (self.spec.driver(), self.spec.step_time_s());
        let [settle, all] = self.spec.steps();
        let (per_turn, per_mean) = (self.spec.steps_per_turn(), self.spec.steps_per_mean());
        for _ in self.steps..all.min(self.steps.saturating_add(steps)) {
            let advance = driver.drive(&mut self.drilling, dt, stepper, executor);
            self.steps += 1;
            let force = advance.force_N + advance.moment_N_m + advance.velocity_m_per_s;
            if !force.iter().all(|x| x.is_finite()) {
                return Err(TrialError::Diverged { revolutions: self.revolutions() });
            }
            let Some(counted) = self.steps.checked_sub(settle).filter(|steps| *steps > 0) else {
                continue;
            };
            let count = &mut self.count;
            count.mean.join(&advance);
            count.bricks_broken += advance.broken as u64;
            if counted.is_multiple_of(per_mean) {
                let mean = std::mem::take(&mut count.mean);
                count.whole.add(&self.drilling, &mean);
                count.turn.add(&self.drilling, &mean);
            }
            if counted.is_multiple_of(per_turn) {
                count.turns.push(std::mem::take(&mut count.turn));
            }
            if counted.is_multiple_of(per_turn.div_ceil(SAMPLES_PER_REVOLUTION))
                || self.steps == all
            {
                let fraction = self.drilling.block().energies().kinetic_fraction();
                count.kinetic_fraction = count.kinetic_fraction.max(fraction);
            }
        }
        Ok(())
    }

    /// Whether all revolutions are done.
    pub fn is_finished(&self) -> bool {
        self.steps >= self.spec.steps()[1]
    }

    /// Revolutions done, settling included.
    pub fn revolutions(&self) -> f64 {
        self.steps as f64 / self.spec.steps_per_turn() as f64
    }

    /// Simulated time, s.
    pub fn time_s(&self) -> f64 {
        self.steps as f64 * self.spec.step_time_s()
    }

    /// Results so far; none while the bit is settling.
    pub fn outcome(&self) -> Option<TrialOutcome> {
        let profile = self.drilling.bit().face().profile();
        let section_m2 = PI * (profile.radius_m().powi(2) - profile.core_radius_m().powi(2));
        (self.count.whole.time_s > 0.0).then(|| self.count.outcome(&self.spec, section_m2))
    }

    /// Specification of the trial.
    pub fn spec(&self) -> &TrialSpec {
        &self.spec
    }

    /// Bit and rock.
    pub fn drilling(&self) -> &Drilling {
        &self.drilling
    }
}
