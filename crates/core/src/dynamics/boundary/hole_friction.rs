//! The friction of the hole's sections while a run changes it.

use serde::{Deserialize, Serialize};

use crate::{
    damage::{Damaged, ensure},
    dynamics::settings::schedule::Ramp,
    well::{Hole, HoleError},
};

/// Why the friction of a hole cannot be changed so.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FrictionFault {
    /// Another number of coefficients than the hole has sections.
    #[error("{given} coefficients of friction were given for a hole of {sections} sections")]
    Count {
        /// Number of coefficients given.
        given: usize,
        /// Number of sections.
        sections: usize,
    },
    /// The time of the change is negative or not finite.
    #[error("the time in which friction changes is {0} s")]
    Ramp(f64),
    /// A coefficient that no wall has.
    #[error(transparent)]
    Hole(#[from] HoleError),
}

/// The kinetic coefficients of a hole's sections, on their way or there.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct HoleFriction {
    ramps: Vec<Ramp>,
    /// Present coefficients of the nodes.
    now: Vec<f64>,
}

impl HoleFriction {
    /// The coefficients that a hole has.
    pub fn of(hole: &Hole) -> Self {
        let now: Vec<f64> =
            hole.sections().iter().map(|section| section.friction.kinetic).collect();
        Self { ramps: now.iter().map(|now| Ramp::resting(*now)).collect(), now }
    }

    /// Sets the sections' coefficients, which they reach in proportion to time within `ramp_s`.
    ///
    /// # Errors
    /// A count that is not the sections', a coefficient or a time that there is not.
    pub fn change(
        &mut self,
        hole: &Hole,
        kinetic: &[f64],
        time_s: f64,
        ramp_s: f64,
    ) -> Result<(), FrictionFault> {
        let (given, sections) = (kinetic.len(), hole.sections().len());
        if given != sections {
            return Err(FrictionFault::Count { given, sections });
        }
        if !(ramp_s.is_finite() && ramp_s >= 0.0) {
            return Err(FrictionFault::Ramp(ramp_s));
        }
        // Any value between two valid coefficients is valid.
        hole.with_friction_of(|section| kinetic[section])?;
        self.ramps = (0..sections)
            .map(|section| Ramp::new([self.now[section], kinetic[section]], time_s, ramp_s))
            .collect();
        Ok(())
    }

    /// Whether the coefficients are still on their way.
    pub fn moves(&self) -> bool {
        self.ramps.iter().zip(&self.now).any(|(ramp, now)| ramp.end() != *now)
    }

    /// The coefficients now.
    pub fn kinetic(&self) -> &[f64] {
        &self.now
    }

    /// The hole with the coefficients of a time.
    ///
    /// # Errors
    /// None that a sound hole gives.
    pub fn reach(&mut self, hole: &Hole, time_s: f64) -> Result<Hole, HoleError> {
        for (now, ramp) in self.now.iter_mut().zip(&self.ramps) {
            *now = ramp.at(time_s);
        }
        self.hole(hole)
    }

    /// The hole with the coefficients of now.
    ///
    /// # Errors
    /// None that a sound hole gives.
    pub fn hole(&self, hole: &Hole) -> Result<Hole, HoleError> {
        hole.with_friction_of(|section| self.now.get(section).copied().unwrap_or(f64::NAN))
    }

    /// Whether stored friction is one of this hole.
    pub fn check(&self, hole: &Hole) -> Result<(), Damaged> {
        let sections = hole.sections().len();
        let fits = self.ramps.len() == sections && self.now.len() == sections;
        ensure(fits && self.hole(hole).is_ok(), "the friction of the hole")
    }
}
