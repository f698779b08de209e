//! Laws of the bit that are sampled at a rate; a front end supplies them in any language.

use std::{f64::consts::TAU, fmt, sync::Arc};

use wholestring::dynamics::{BitExcitation, BitRockLaw, BitRockStep, Shake, SteadyCut};

use crate::{cancellation::CancellationToken, error::Error};

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

// Laws that are sampled at a rate, between two samples: a law of the bit by a zero-order hold of
// its answer per weight, an excitation by a first-order hold.

/// Fraction of a period within which a time counts as its end.
const EARLY: f64 = 1e-6;

/// A law of the bit between two samples: depth of cut and torque in proportion to the weight, as in
/// its last answer. It is not evaluated while the bit is off the rock.
#[derive(Debug)]
pub(super) struct HeldLaw {
    pub(super) title: String,
    pub(super) law: SampledLaw<BitReading, BitAnswer>,
    /// Depth of cut, m/N, and torque, m, per weight at the start.
    pub(super) first: [f64; 2],
    pub(super) failed: CancellationToken,
}

impl BitRockLaw for HeldLaw {
    fn name(&self) -> &str {
        &self.title
    }

    /// Time, s; angle, rad; drilled, m; periods begun; depth of cut and torque per weight.
    fn initial_state(&self) -> Vec<f64> {
        let [depth_m_per_N, torque_m] = self.first;
        vec![0.0, 0.0, 0.0, 1.0, depth_m_per_N, torque_m]
    }

    fn cut(&self, state: &[f64], weight_on_bit_N: f64, rotary_speed_rad_per_s: f64) -> SteadyCut {
        let &[.., depth_m_per_N, torque_m] = state else {
            return SteadyCut::default();
        };
        let depth_of_cut_m = depth_m_per_N * weight_on_bit_N;
        SteadyCut {
            depth_of_cut_m,
            torque_N_m: torque_m * weight_on_bit_N,
            rate_of_penetration_m_per_s: depth_of_cut_m * rotary_speed_rad_per_s / TAU,
        }
    }

    fn advance(&self, state: &mut [f64], step: &BitRockStep) {
        let [time_s, angle_rad, drilled_m, periods, depth_m_per_N, torque_m] = state else {
            return;
        };
        *time_s += step.dt_s;
        *angle_rad += step.bit_speed_rad_per_s * step.dt_s;
        *drilled_m += step.advance_m;
        let passed = *time_s * self.law.rate_Hz + EARLY;
        if passed < *periods || step.weight_on_bit_N <= 0.0 || self.failed.is_cancelled() {
            return;
        }
        *periods = passed.floor() + 1.0;
        let reading = BitReading {
            time_s: *time_s,
            weight_on_bit_N: step.weight_on_bit_N,
            rotary_speed_rad_per_s: step.bit_speed_rad_per_s,
            angle_rad: *angle_rad,
            drilled_m: *drilled_m,
        };
        match (self.law.ask)(&reading) {
            Some(answer) => {
                *depth_m_per_N = answer.depth_of_cut_m / step.weight_on_bit_N;
                *torque_m = answer.torque_N_m / step.weight_on_bit_N;
            }
            None => {
                self.failed.cancel();
            }
        }
    }
}

/// An excitation between two samples: linear interpolation between its answers, evaluated one
/// period ahead.
#[derive(Debug)]
pub(super) struct HeldShake {
    pub(super) title: String,
    pub(super) law: SampledLaw<ShakeReading, Shake>,
    /// Front, m, and torque at the start and after the first period.
    pub(super) first: [f64; 4],
    pub(super) failed: CancellationToken,
}

impl BitExcitation for HeldShake {
    fn name(&self) -> &str {
        &self.title
    }

    /// Time, s; angle, rad; start and end of the period, s; front and torque at both.
    fn initial_state(&self) -> Vec<f64> {
        let period_s = 1.0 / self.law.rate_Hz;
        [0.0, 0.0, 0.0, period_s].into_iter().chain(self.first).collect()
    }

    fn shake(&self, state: &[f64], _bit_angle_rad: f64, time_s: f64) -> Shake {
        let &[_, _, from_s, to_s, front_m, torque, next_front_m, next_torque] = state else {
            return Shake::default();
        };
        let part = (time_s - from_s) / (to_s - from_s);
        Shake {
            front_m: libm::fma(part, next_front_m - front_m, front_m),
            torque: libm::fma(part, next_torque - torque, torque),
        }
    }

    fn advance(&self, state: &mut [f64], step: &BitRockStep) {
        let [time_s, angle_rad, from_s, to_s, front_m, torque, next_front_m, next_torque] = state
        else {
            return;
        };
        *time_s += step.dt_s;
        *angle_rad += step.bit_speed_rad_per_s * step.dt_s;
        let period_s = (1.0 / self.law.rate_Hz).max(step.dt_s);
        if *time_s < *to_s - EARLY * period_s || self.failed.is_cancelled() {
            return;
        }
        let next_s = *to_s + period_s;
        let reading = ShakeReading {
            time_s: next_s,
            angle_rad: libm::fma(step.bit_speed_rad_per_s, next_s - *time_s, *angle_rad),
        };
        match (self.law.ask)(&reading) {
            Some(shake) => {
                (*from_s, *to_s) = (*to_s, next_s);
                (*front_m, *torque) = (*next_front_m, *next_torque);
                (*next_front_m, *next_torque) = (shake.front_m, shake.torque);
            }
            None => {
                self.failed.cancel();
            }
        }
    }
}
