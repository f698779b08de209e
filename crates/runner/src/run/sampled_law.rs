//! Laws of the bit that are sampled at a rate; a front end supplies them in any language.

use std::{fmt, sync::Arc};

use crate::error::Error;

/// Input of a law of the bit: the state of drilling at the end of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BitReading {
    /// Time since the start of the run, s.
    pub time_s: f64,
    /// Weight on bit, N, more than zero.
    pub weight_on_bit_N: f64,
    /// Speed of the bit, motor included, rad/s.
    pub rotary_speed_rad_per_s: f64,
    /// Angle through which the bit has turned since the start of the run, rad.
    pub angle_rad: f64,
    /// Length of rock drilled along the hole since the start of the run, m.
    pub drilled_m: f64,
}

/// Output of a law of the bit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BitAnswer {
    /// Depth of cut per revolution at that weight, m; zero or more.
    pub depth_of_cut_m: f64,
    /// Torque on bit, N·m; zero or more.
    pub torque_N_m: f64,
}

/// Input of an excitation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShakeReading {
    /// Time since the start of the run, s.
    pub time_s: f64,
    /// Angle of the bit at that time, extrapolated at its current speed, rad.
    pub angle_rad: f64,
}

/// Function of a law; returns `None` if it has no answer.
pub type Answering<I, O> = dyn Fn(&I) -> Option<O> + Send + Sync;

/// A law that is sampled at a rate. If it returns no answer, the run stops.
pub struct SampledLaw<I, O> {
    /// Its name, which identifies it in a checkpoint.
    pub name: String,
    /// Sampling rate, Hz; at most once per step.
    pub rate_Hz: f64,
    /// The law itself.
    pub ask: Arc<Answering<I, O>>,
}

impl<I, O> Clone for SampledLaw<I, O> {
    fn clone(&self) -> Self {
        Self { name: self.name.clone(), rate_Hz: self.rate_Hz, ask: Arc::clone(&self.ask) }
    }
}

impl<I, O> fmt::Debug for SampledLaw<I, O> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.title())
    }
}

impl<I, O> SampledLaw<I, O> {
    /// Name and rate.
    pub(super) fn title(&self) -> String {
        format!("{} at {} Hz", self.name, self.rate_Hz)
    }

    pub(super) fn check(&self) -> Result<(), Error> {
        if self.rate_Hz.is_finite() && self.rate_Hz > 0.0 {
            return Ok(());
        }
        Err(Error::BadInput(format!(
            "the rate of {} is {} Hz: expected more than zero",
            self.name, self.rate_Hz
        )))
    }
}
