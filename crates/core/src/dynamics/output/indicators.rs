//! Motion of a run in the indicators that the field uses.

use serde::{Deserialize, Serialize};

use super::statistic::{Moments, Statistic};
use crate::{
    outcome::{
        Column, History, Profile, TIME_SERIES, TimeSeries,
        samples::{Samples, ends, sum},
    },
    rod::mesh::Mesh,
};

/// A bit that turns slower than this is stuck, rad/s: one revolution a minute.
const STUCK_RAD_PER_S: f64 = std::f64::consts::TAU / 60.0;

/// A speed that swings by less than this part of its mean, as a standard deviation, has no period.
const STEADY: f64 = 0.01;

/// Part of the standard deviation by which the speed must pass its mean to count as having passed
/// it.
const HYSTERESIS: f64 = 0.5;

/// A node whirls where its motion round the hole's axis is at least this part of its lateral motion
/// ...
const COHERENT: f64 = 0.5;

/// ... and goes round at no less than this part of the rotary speed: a string that slowly climbs
/// the wall does not whirl.
const SLOWEST_WHIRL: f64 = 0.1;

/// A node that keeps this near to the hole's axis, m, does not whirl, whatever it does there.
const SMALLEST_WHIRL_M: f64 = 1e-4;

/// Whirl, stick-slip and the use of the top drive over the window.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Indicators {
    /// Stick-slip of the bit, where the string turns.
    pub stick_slip: Option<StickSlip>,
    /// The fastest whirl against the rotation, if anything whirls so.
    pub backward_whirl: Option<Whirl>,
    /// The fastest whirl with the rotation, if anything whirls so.
    pub forward_whirl: Option<Whirl>,
    /// Surface torque against the top drive's rated torque, where that is known.
    pub top_drive: Option<TorqueUse>,
}

/// Unsteadiness of the bit's rotation.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct StickSlip {
    /// `(max − min)/(2 mean)` of the bit's rotary speed: one where it just stops; none where it
    /// does not turn on average.
    pub severity: Option<f64>,
    /// The same of the surface torque, which is all that a rig without downhole tools can see.
    pub torque_severity: Option<f64>,
    /// Mean time between two rises of the bit's speed through its mean, s; none where it is steady
    /// or the window holds less than two of them.
    pub period_s: Option<f64>,
    /// Part of the time in which the bit turned slower than 1 rev/min.
    #[serde(with = "crate::finite")]
    pub stuck_fraction: f64,
    /// Largest rotary speed of the bit, rad/s.
    #[serde(with = "crate::finite")]
    pub bit_speed_max_rad_per_s: f64,
}

/// Whirl in one direction.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Whirl {
    /// Measured depth of the node that goes round fastest, m.
    #[serde(with = "crate::finite")]
    pub md_m: f64,
    /// Its angular velocity about the hole's axis, rad/s; clockwise looking down the hole is
    /// positive.
    #[serde(with = "crate::finite")]
    pub rate_rad_per_s: f64,
    /// That over the rotary speed.
    #[serde(with = "crate::finite")]
    pub ratio: f64,
    /// Part of the string's length that whirls in this direction.
    #[serde(with = "crate::finite")]
    pub length_fraction: f64,
}

/// Used fraction of the rated torque.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct TorqueUse {
    /// 95th percentile of the surface torque over the rated torque.
    #[serde(with = "crate::finite")]
    pub p95: f64,
    /// Largest surface torque over the rated torque.
    #[serde(with = "crate::finite")]
    pub max: f64,
}

impl StickSlip {
    /// Of the rotary speed of the bit and the surface torque, sampled every `interval_s`; none of
    /// no samples.
    pub fn of(
        bit_speed_rad_per_s: &(impl Samples + ?Sized),
        torque_N_m: &(impl Samples + ?Sized),
        interval_s: f64,
    ) -> Option<Self> {
        let speed = Moments::of(bit_speed_rad_per_s)?;
        let is_stuck = |_, speed: f64| f64::from(u8::from(speed.abs() < STUCK_RAD_PER_S));
        let stuck = sum(bit_speed_rad_per_s, is_stuck);
        Some(Self {
            severity: severity(&speed),
            torque_severity: Moments::of(torque_N_m).as_ref().and_then(severity),
            period_s: period_s(bit_speed_rad_per_s, &speed, interval_s),
            stuck_fraction: stuck / bit_speed_rad_per_s.count() as f64,
            bit_speed_max_rad_per_s: speed.max,
        })
    }
}

fn severity(moments: &Moments) -> Option<f64> {
    (moments.mean > 0.0).then(|| (moments.max - moments.min) / (2.0 * moments.mean))
}

/// Mean time between rises through the mean, each after a fall below it.
fn period_s(speed: &(impl Samples + ?Sized), moments: &Moments, interval_s: f64) -> Option<f64> {
    if moments.std <= STEADY * moments.mean.abs() {
        return None;
    }
    let band = HYSTERESIS * moments.std;
    let mut below = false;
    let [mut row, mut rises, mut first_rise, mut last_rise] = [0_usize; 4];
    speed.each(&mut |speeds| {
        for speed in speeds {
            if *speed < moments.mean - band {
                below = true;
            } else if below && *speed > moments.mean + band {
                below = false;
                rises += 1;
                last_rise = row;
                if rises == 1 {
                    first_rise = row;
                }
            }
            row += 1;
        }
    });
    let periods = rises.checked_sub(1).filter(|periods| *periods >= 2)?;
    Some((last_rise - first_rise) as f64 * interval_s / periods as f64)
}

/// Inputs of the indicators.
pub(in crate::dynamics) struct Motion<'a> {
    pub mesh: &'a Mesh,
    pub nodes: &'a Profile,
    pub history: History<'a>,
    /// Row of the history at which the window begins.
    pub from: usize,
    /// Whether the operation turns the string.
    pub rotates: bool,
    pub rated_torque_N_m: Option<f64>,
}

const TIME: &Column<TimeSeries> = Column::named(TIME_SERIES, "time_s");
const BIT_SPEED: &Column<TimeSeries> = Column::named(TIME_SERIES, "bit_rotary_speed_rad_per_s");
const TORQUE: &Column<TimeSeries> = Column::named(TIME_SERIES, "surface_torque_N_m");

impl Indicators {
    pub(in crate::dynamics) fn of(m: &Motion<'_>) -> Self {
        let [speed, torque, time_s] =
            [BIT_SPEED, TORQUE, TIME].map(|column| m.history.scalar(column, m.from));
        let interval_s = match (ends(&time_s), time_s.count()) {
            (Some([first, last]), count) if count > 1 => (last - first) / (count - 1) as f64,
            _ => 0.0,
        };
        let mean_speed = Moments::of(&speed).map_or(0.0, |moments| moments.mean);
        let whirl = |sign: f64| {
            (m.rotates && mean_speed > 0.0).then(|| whirl(m, mean_speed, sign)).flatten()
        };
        Self {
            stick_slip: if m.rotates { StickSlip::of(&speed, &torque, interval_s) } else { None },
            backward_whirl: whirl(-1.0),
            forward_whirl: whirl(1.0),
            top_drive: m.rated_torque_N_m.zip(Statistic::of(&torque)).map(|(rated, torque)| {
                TorqueUse { p95: torque.p95 / rated, max: torque.max / rated }
            }),
        }
    }
}

fn whirl(m: &Motion<'_>, rotary_speed: f64, sign: f64) -> Option<Whirl> {
    let rates = &m.nodes.whirl_rate_rad_per_s;
    let whirls = |i: &usize| {
        m.nodes.whirl_coherence[*i] >= COHERENT
            && m.nodes.lateral_offset_m[*i] >= SMALLEST_WHIRL_M
            && sign * rates[*i] >= SLOWEST_WHIRL * rotary_speed
    };
    let whirling: Vec<usize> = (0..rates.len()).filter(whirls).collect();
    let fastest = *whirling.iter().max_by(|a, b| rates[**a].abs().total_cmp(&rates[**b].abs()))?;
    let length_m: f64 = whirling.iter().map(|i| m.mesh.tributary_length_m(*i)).sum();
    Some(Whirl {
        md_m: m.nodes.md_m[fastest],
        rate_rad_per_s: rates[fastest],
        ratio: rates[fastest] / rotary_speed,
        length_fraction: length_m / m.mesh.length_m(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    const INTERVAL_S: f64 = 0.01;

    fn speeds(speed: impl Fn(f64) -> f64) -> Vec<f64> {
        (0..6000).map(|row| speed(f64::from(row) * INTERVAL_S)).collect()
    }

    /// `Ω (1 + a sin ωt)` has severity `a` and the period `2π/ω`. Sampled, its extremes are met to
    /// within `1 − cos(π·0.01 s/T)` = 2e-5, a rise to within a sample: 0.01 s over ten periods of
    /// 5.3 s is 2e-4.
    #[test]
    fn of_a_swinging_bit() {
        let swing = |part: f64| speeds(|t| 7.0 * (1.0 + part * (TAU * t / 5.3).sin()));
        let torque = vec![3.0; 6000];
        let found = StickSlip::of(&swing(0.6), &torque, INTERVAL_S).unwrap();
        // The window of 60 s holds 11.3 periods: its mean is off by up to 1/(2π·11.3).
        assert!((found.severity.unwrap() - 0.6).abs() < 0.6 * 0.015, "{found:?}");
        assert!((found.period_s.unwrap() / 5.3 - 1.0).abs() < 3e-4, "{found:?}");
        assert_eq!(found.torque_severity, Some(0.0));
        assert_eq!(found.stuck_fraction, 0.0);
        let steady = StickSlip::of(&swing(0.01), &torque, INTERVAL_S).unwrap();
        assert_eq!(steady.period_s, None);
    }

    /// A bit that is stationary for 2 s of every 5 s and slips at 10 rad/s: stuck for 0.4 of the
    /// time, severity `10/(2·6)`.
    #[test]
    fn of_a_bit_that_sticks() {
        let speed = speeds(|t| if t.rem_euclid(5.0) < 2.0 { 0.0 } else { 10.0 });
        let found = StickSlip::of(&speed, &speed, INTERVAL_S).unwrap();
        assert!((found.stuck_fraction - 0.4).abs() < 1e-3, "{found:?}");
        assert!((found.severity.unwrap() - 10.0 / 12.0).abs() < 2e-3, "{found:?}");
        assert!((found.period_s.unwrap() - 5.0).abs() < 1e-3, "{found:?}");
        assert_eq!(found.bit_speed_max_rad_per_s, 10.0);
        // One that never turns has no severity, and one that is not sampled nothing at all.
        let still = StickSlip::of(&[0.0; 10], &[1.0; 10], INTERVAL_S).unwrap();
        assert_eq!((still.severity, still.stuck_fraction), (None, 1.0));
        assert_eq!(StickSlip::of(&[], &[], INTERVAL_S), None);
    }
}
