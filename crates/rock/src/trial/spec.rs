//! Specification of a trial.

use std::f64::consts::TAU;

use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::drilling::{DrillingError, Driver};

/// A bit alone on the rock under one weight at one speed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct TrialSpec {
    /// Weight on bit, N.
    pub weight_N: f64,
    /// Rotary speed, rad/s.
    pub rotary_rad_per_s: f64,
    /// Mass that moves along the hole with the bit, kg: more of it steadies the bit, and makes its
    /// weight fluctuate more.
    pub mass_kg: f64,
    /// Revolutions before anything is counted, in which the bit makes its bottom.
    pub settle_revolutions: f64,
    /// Revolutions that are counted.
    pub revolutions: f64,
    /// The time over which forces are averaged before their standard deviations are taken, s. A
    /// revolution takes a whole number of equal times, which are no longer than this.
    pub averaging_s: f64,
    /// The time in which bit and rock are driven at a time, s: about a step of a string. Such an
    /// average takes a whole number of equal steps, which are no longer than this.
    pub step_s: f64,
}

/// Why a trial has no outcome.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum TrialError {
    /// The bit cannot drill.
    #[error(transparent)]
    Drilling(#[from] DrillingError),
    /// A number of the trial that makes no sense.
    #[error("{name} of {value}, expected {expected}")]
    Number {
        /// Which number.
        name: &'static str,
        /// Its value.
        value: f64,
        /// Expected range.
        expected: &'static str,
    },
    /// The forces are beyond all numbers.
    #[error(
        "bit and rock diverged after {revolutions:.2} revolutions: the mass that moves with the \
         bit may be too small, or the density scaled too far"
    )]
    Diverged {
        /// Revolutions until then.
        revolutions: f64,
    },
}

impl TrialSpec {
    /// More steps than this are no trial.
    const MAX_STEPS: f64 = 1e12;

    pub(super) fn check(&self) -> Result<(), TrialError> {
        let positive = |name, value: f64| match value > 0.0 && value.is_finite() {
            true => Ok(()),
            false => Err(TrialError::Number { name, value, expected: "more than zero" }),
        };
        positive("weight on bit (N)", self.weight_N)?;
        positive("rotary speed (rad/s)", self.rotary_rad_per_s)?;
        positive("moving mass (kg)", self.mass_kg)?;
        positive("averaging time (s)", self.averaging_s)?;
        positive("step (s)", self.step_s)?;
        positive("revolutions", self.revolutions)?;
        if !(self.settle_revolutions >= 0.0 && self.settle_revolutions.is_finite()) {
            return Err(TrialError::Number {
                name: "settling revolutions",
                value: self.settle_revolutions,
                expected: "none or more",
            });
        }
        let steps = TAU / self.rotary_rad_per_s / self.step_s.min(self.averaging_s)
            * (1.0 + self.settle_revolutions + self.revolutions);
        if steps > Self::MAX_STEPS {
            return Err(TrialError::Number {
                name: "number of steps",
                value: steps,
                expected: "at most 1e12",
            });
        }
        Ok(())
    }

    /// Drive of the bit.
    pub(super) fn driver(&self) -> Driver {
        Driver::Weight {
            weight_N: self.weight_N,
            mass_kg: self.mass_kg,
            rotary_rad_per_s: self.rotary_rad_per_s,
        }
    }

    /// Averages of a revolution.
    fn means_per_turn(&self) -> u64 {
        parts(TAU / self.rotary_rad_per_s, self.averaging_s)
    }

    /// Steps of an average.
    pub(super) fn steps_per_mean(&self) -> u64 {
        parts(self.averaging_time_s(), self.step_s)
    }

    /// Steps of a revolution.
    pub(super) fn steps_per_turn(&self) -> u64 {
        self.means_per_turn() * self.steps_per_mean()
    }

    /// Time of an average, s.
    pub fn averaging_time_s(&self) -> f64 {
        TAU / self.rotary_rad_per_s / self.means_per_turn() as f64
    }

    /// Time of a step, s.
    pub fn step_time_s(&self) -> f64 {
        self.averaging_time_s() / self.steps_per_mean() as f64
    }

    /// Steps before counting begins, and steps of all: of whole averages.
    pub(super) fn steps(&self) -> [u64; 2] {
        let u64 = |revolutions: f64| (revolutions * self.means_per_turn() as f64).round() as u64;
        let settle = u64(self.settle_revolutions);
        let all = settle + u64(self.revolutions).max(1);
        [settle, all].map(|means| means * self.steps_per_mean())
    }

    /// Time of the whole trial, s.
    pub fn duration_s(&self) -> f64 {
        self.steps()[1] as f64 * self.step_time_s()
    }
}

/// Into how many equal parts a time is cut that are no longer than another. A part that rounding
/// has made a little too long is none the worse.
fn parts(time_s: f64, longest_s: f64) -> u64 {
    (time_s / longest_s * (1.0 - 1e-12)).ceil().max(1.0) as u64
}
