//! Results of a trial.

use std::f64::consts::TAU;

use serde::{Deserialize, Serialize};

use super::TrialSpec;
use crate::drilling::{Advance, Progress};

/// Means of a bit alone on the rock under one weight at one speed.
///
/// Standard deviations are those of means over [`averaging_time_s`](Self::averaging_time_s). The
/// errors are standard errors of the means, each revolution being one measurement; none where less
/// than two whole revolutions were counted. Successive revolutions are not independent, because
/// each cuts the surface left by the one before, so that the errors are somewhat too small.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct TrialOutcome {
    /// Weight that was put on the bit, N.
    #[serde(with = "wholestring_numbers::finite")]
    pub weight_on_bit_N: f64,
    /// Rotary speed, rad/s.
    #[serde(with = "wholestring_numbers::finite")]
    pub rotary_speed_rad_per_s: f64,
    /// Mean rate of penetration, m/s.
    #[serde(with = "wholestring_numbers::finite")]
    pub rate_of_penetration_m_per_s: f64,
    /// Its standard error, m/s.
    pub rate_of_penetration_error_m_per_s: Option<f64>,
    /// Mean depth of cut per revolution, m.
    #[serde(with = "wholestring_numbers::finite")]
    pub depth_of_cut_m: f64,
    /// Mean torque of the bit on the rock, N·m.
    #[serde(with = "wholestring_numbers::finite")]
    pub torque_N_m: f64,
    /// Its standard error, N·m.
    pub torque_error_N_m: Option<f64>,
    /// Standard deviation of the torque, N·m.
    #[serde(with = "wholestring_numbers::finite")]
    pub torque_std_N_m: f64,
    /// Mean weight carried by the rock, N: the weight on the bit less the force that accelerates
    /// it.
    #[serde(with = "wholestring_numbers::finite")]
    pub weight_borne_N: f64,
    /// Standard deviation of the weight that the rock bore, N.
    #[serde(with = "wholestring_numbers::finite")]
    pub weight_on_bit_std_N: f64,
    /// Work of the bit per volume of rock that it broke, Pa; none where it broke nothing.
    pub specific_energy_Pa: Option<f64>,
    /// Work of the bit per volume of the hole that it made, its section times its way, Pa: Teale's
    /// mechanical specific energy (*International Journal of Rock Mechanics and Mining Sciences* 2,
    /// 1965). None where the bit did not get on.
    pub mechanical_specific_energy_Pa: Option<f64>,
    /// Elements that it broke.
    pub bricks_broken: u64,
    /// Largest kinetic energy of the rock over the work of its deformation.
    #[serde(with = "wholestring_numbers::finite")]
    pub kinetic_fraction: f64,
    /// Revolutions counted.
    #[serde(with = "wholestring_numbers::finite")]
    pub revolutions: f64,
    /// Time counted, s.
    #[serde(with = "wholestring_numbers::finite")]
    pub time_s: f64,
    /// Time of the means that go into standard deviations, s.
    #[serde(with = "wholestring_numbers::finite")]
    pub averaging_time_s: f64,
}

/// Sums taken during a trial.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub(super) struct Count {
    /// All of it but the average under way.
    pub(super) whole: Progress,
    /// The average under way.
    pub(super) mean: Advance,
    /// Each whole revolution.
    pub(super) turns: Vec<Progress>,
    /// The revolution under way.
    pub(super) turn: Progress,
    pub(super) bricks_broken: u64,
    pub(super) kinetic_fraction: f64,
}

impl Count {
    /// The means.
    pub(super) fn outcome(&self, spec: &TrialSpec, section_m2: f64) -> TrialOutcome {
        let whole = &self.whole;
        let hole_m3 = section_m2 * whole.depth_m;
        TrialOutcome {
            weight_on_bit_N: spec.weight_N,
            rotary_speed_rad_per_s: spec.rotary_rad_per_s,
            rate_of_penetration_m_per_s: whole.rate_m_per_s(),
            rate_of_penetration_error_m_per_s: self.error(Progress::rate_m_per_s),
            depth_of_cut_m: whole.depth_of_cut_m(),
            torque_N_m: whole.torque_N_m(),
            torque_error_N_m: self.error(Progress::torque_N_m),
            torque_std_N_m: whole.torque_deviation_N_m(),
            weight_borne_N: whole.weight_N(),
            weight_on_bit_std_N: whole.weight_deviation_N(),
            specific_energy_Pa: (self.bricks_broken > 0).then(|| whole.specific_energy_Pa()),
            mechanical_specific_energy_Pa: (hole_m3 > 0.0).then(|| whole.work_J / hole_m3),
            bricks_broken: self.bricks_broken,
            kinetic_fraction: self.kinetic_fraction,
            revolutions: whole.turned_rad / TAU,
            time_s: whole.time_s,
            averaging_time_s: spec.averaging_time_s(),
        }
    }

    /// Standard error of a mean, from the revolutions.
    fn error(&self, mean: impl Fn(&Progress) -> f64) -> Option<f64> {
        let count = self.turns.len();
        if count < 2 {
            return None;
        }
        let means: Vec<f64> = self.turns.iter().map(mean).collect();
        let middle = means.iter().sum::<f64>() / count as f64;
        let squares: f64 = means.iter().map(|x| (x - middle).powi(2)).sum();
        Some((squares / ((count - 1) * count) as f64).sqrt())
    }
}
