//! Lamps of the present motion, by the measures of a run's summary.

use std::collections::VecDeque;

use serde::Serialize;
use utoipa::ToSchema;
use wholestring::dynamics::{Simulation, StickSlip, TorsionalString, Whirl};
use wholestring_judge::{Severity, stick_slip_severity, top_drive_severity, whirl_severity};

use crate::words;

/// Number of torsional periods over which stick-slip is measured.
const PERIODS: f64 = 2.0;

/// Minimum and maximum of that time, s.
const MEASURED_S: [f64; 2] = [5.0, 60.0];

/// Shortest window from which whirl is evaluated, s.
pub(super) const WHIRL_S: f64 = 2.0;

/// Lamps of the driller's seat.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, ToSchema)]
pub struct Lamps {
    /// Stick-slip over the last two torsional periods; null if the string does not rotate.
    pub stick_slip: Option<StickSlipLamp>,
    /// The fastest backward whirl.
    pub backward_whirl: Option<WhirlLamp>,
    /// The fastest forward whirl.
    pub forward_whirl: Option<WhirlLamp>,
    /// Whether the top drive's torque is limited by its capacity.
    pub top_drive_stalls: bool,
    /// Largest surface torque of that time over the top drive's maximum torque, or else over its
    /// rated torque; null if neither is known.
    pub torque_use: Option<f64>,
    /// Severity of the stick-slip: `ok`, `note` or `warning`; null if there is none to judge.
    #[schema(value_type = Option<words::Severity>)]
    pub stick_slip_severity: Option<&'static str>,
    /// Severity of the whirl, of the backward one if there are both: `ok`, `note` or `warning`.
    #[schema(value_type = Option<words::Severity>)]
    pub whirl_severity: Option<&'static str>,
    /// Severity of the top drive's torque: `ok`, `note`, `warning` or `error`; null if its limit is
    /// unknown.
    #[schema(value_type = Option<words::Severity>)]
    pub top_drive_severity: Option<&'static str>,
}

/// Unsteadiness of the bit's rotation.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, ToSchema)]
pub struct StickSlipLamp {
    /// `(max - min)/(2 mean)` of the bit's speed; null if its mean is zero.
    pub severity: Option<f64>,
    /// Mean time between two slips, s; null for steady rotation.
    pub period_s: Option<f64>,
    /// Fraction of the time in which the bit is stuck.
    pub stuck_fraction: f64,
}

/// Whirl in one direction.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, ToSchema)]
pub struct WhirlLamp {
    /// Depth at which it is fastest, m.
    pub md_m: f64,
    /// Its rate over the rotary speed.
    pub ratio: f64,
    /// Fraction of the string in this whirl.
    pub length_fraction: f64,
}

impl From<Whirl> for WhirlLamp {
    fn from(Whirl { md_m, ratio, length_fraction, .. }: Whirl) -> Self {
        Self { md_m, ratio, length_fraction }
    }
}

/// Input of the lamps: the last samples, and the window of the simulation.
#[derive(Debug)]
pub(super) struct Watched {
    most: usize,
    sample_s: f64,
    limit_N_m: Option<f64>,
    rotates: bool,
    bit_speed: VecDeque<f64>,
    torque: VecDeque<f64>,
    whirl: [Option<WhirlLamp>; 2],
}

impl Watched {
    pub(super) fn new(simulation: &Simulation, limit_N_m: Option<f64>, rotates: bool) -> Self {
        let period_s = 1.0 / TorsionalString::of(simulation.mesh()).frequency_Hz;
        let [least_s, most_s] = MEASURED_S;
        let measured_s = (PERIODS * period_s).clamp(least_s, most_s);
        let sample_s = simulation.sample_interval_s();
        Self {
            most: (measured_s / sample_s).ceil() as usize,
            sample_s,
            limit_N_m,
            rotates,
            bit_speed: VecDeque::new(),
            torque: VecDeque::new(),
            whirl: [None; 2],
        }
    }

    /// Adds the samples from a row of the series on.
    pub(super) fn add(&mut self, simulation: &Simulation, row: usize) {
        let series = simulation.series();
        for (series, new) in [
            (&mut self.bit_speed, &series.bit_rotary_speed_rad_per_s[row..]),
            (&mut self.torque, &series.surface_torque_N_m[row..]),
        ] {
            let new = &new[new.len().saturating_sub(self.most)..];
            let over = (series.len() + new.len()).saturating_sub(self.most);
            series.drain(..over);
            series.extend(new);
        }
    }

    /// The present lamps.
    pub(super) fn lamps(&mut self, simulation: &Simulation) -> Lamps {
        let series = simulation.series();
        if let [first, .., last] = series.time_s[..]
            && last - first >= WHIRL_S
        {
            let found = simulation.indicators();
            self.whirl =
                [found.backward_whirl, found.forward_whirl].map(|whirl| whirl.map(Into::into));
        }
        let [backward_whirl, forward_whirl] = self.whirl;
        let largest = self.torque.iter().fold(0.0_f64, |most, torque| most.max(torque.abs()));
        let (speed, torque) = (self.bit_speed.make_contiguous(), self.torque.make_contiguous());
        let stick_slip = StickSlip::of(speed, torque, self.sample_s).filter(|_| self.rotates);
        let is_stalled = simulation.is_top_drive_stalled();
        let torque_use = self.limit_N_m.map(|limit| largest / limit);
        let whirl = backward_whirl.or(forward_whirl);
        let whirl = whirl.map_or(Severity::Ok, |_| whirl_severity(backward_whirl.is_some()));
        Lamps {
            stick_slip_severity: stick_slip
                .as_ref()
                .and_then(stick_slip_severity)
                .map(Severity::name),
            stick_slip: stick_slip.map(|stick_slip| StickSlipLamp {
                severity: stick_slip.severity,
                period_s: stick_slip.period_s,
                stuck_fraction: stick_slip.stuck_fraction,
            }),
            backward_whirl,
            forward_whirl,
            top_drive_stalls: is_stalled,
            torque_use,
            whirl_severity: Some(whirl.name()),
            top_drive_severity: (is_stalled || torque_use.is_some())
                .then(|| top_drive_severity(torque_use.unwrap_or(1.0), is_stalled).name()),
        }
    }
}
