//! What the motion amounts to now, by the measures of a run's summary.

use std::collections::VecDeque;

use serde::Serialize;
use utoipa::ToSchema;
use wholestring::dynamics::{Simulation, StickSlip, TorsionalString, Whirl};
use wholestring_judge::{Severity, stick_slip_severity, top_drive_severity, whirl_severity};

/// Torsional periods over which stick-slip is measured.
const PERIODS: f64 = 2.0;

/// Least and most of that time, s.
const MEASURED_S: [f64; 2] = [5.0, 60.0];

/// A window that is shorter says nothing of whirl yet, s.
pub(super) const WHIRL_S: f64 = 2.0;

/// Lamps of the driller's seat.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, ToSchema)]
pub struct Lamps {
    /// Stick-slip over the last two torsional periods; null of a string that does not turn.
    pub stick_slip: Option<StickSlipLamp>,
    /// The fastest whirl against the rotation.
    pub backward_whirl: Option<WhirlLamp>,
    /// The fastest whirl with the rotation.
    pub forward_whirl: Option<WhirlLamp>,
    /// Whether the top drive is asked for more torque than it gives.
    pub top_drive_stalls: bool,
    /// Largest surface torque of that time over what the top drive gives at most, or else over its
    /// rated torque; null where neither is known.
    pub torque_use: Option<f64>,
    /// Severity of the stick-slip: `ok`, `note` or `warning`; null where there is none to judge.
    pub stick_slip_severity: Option<&'static str>,
    /// Severity of the whirl, of the backward one where there are both: `ok`, `note` or `warning`.
    pub whirl_severity: Option<&'static str>,
    /// Severity of the top drive's torque: `ok`, `note`, `warning` or `error`; null where its
    /// limit is not known.
    pub top_drive_severity: Option<&'static str>,
}

/// How unsteadily the bit turns.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, ToSchema)]
pub struct StickSlipLamp {
    /// `(max - min)/(2 mean)` of the bit's speed; null where it does not turn on average.
    pub severity: Option<f64>,
    /// Mean time between two slips, s; null where it is steady.
    pub period_s: Option<f64>,
    /// Part of the time in which the bit stood.
    pub stuck_fraction: f64,
}

/// Whirl in one direction.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, ToSchema)]
pub struct WhirlLamp {
    /// Where it is fastest, m.
    pub md_m: f64,
    /// Its rate over the rotary speed.
    pub ratio: f64,
    /// Part of the string that whirls so.
    pub length_fraction: f64,
}

impl From<Whirl> for WhirlLamp {
    fn from(Whirl { md_m, ratio, length_fraction, .. }: Whirl) -> Self {
        Self { md_m, ratio, length_fraction }
    }
}

/// What the lamps are made from: the last samples, and the window of the simulation.
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
    pub(super) fn new(of: &Simulation, limit_N_m: Option<f64>, rotates: bool) -> Self {
        let period_s = 1.0 / TorsionalString::of(of.mesh()).frequency_Hz;
        let [least_s, most_s] = MEASURED_S;
        let measured_s = (PERIODS * period_s).clamp(least_s, most_s);
        let sample_s = of.sample_interval_s();
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

    /// Takes in the samples from a row of the series on.
    pub(super) fn add(&mut self, of: &Simulation, row: usize) {
        let series = of.series();
        for (kept, new) in [
            (&mut self.bit_speed, &series.bit_rotary_speed_rad_per_s[row..]),
            (&mut self.torque, &series.surface_torque_N_m[row..]),
        ] {
            let new = &new[new.len().saturating_sub(self.most)..];
            let over = (kept.len() + new.len()).saturating_sub(self.most);
            kept.drain(..over);
            kept.extend(new);
        }
    }

    /// The lamps now.
    pub(super) fn lamps(&mut self, of: &Simulation) -> Lamps {
        let series = of.series();
        if let [first, .., last] = series.time_s[..]
            && last - first >= WHIRL_S
        {
            let found = of.indicators();
            self.whirl = [found.backward_whirl, found.forward_whirl].map(|of| of.map(Into::into));
        }
        let [backward_whirl, forward_whirl] = self.whirl;
        let largest = self.torque.iter().fold(0.0_f64, |most, of| most.max(of.abs()));
        let (speed, torque) = (self.bit_speed.make_contiguous(), self.torque.make_contiguous());
        let stick_slip = StickSlip::of(speed, torque, self.sample_s).filter(|_| self.rotates);
        let is_stalled = of.is_top_drive_stalled();
        let torque_use = self.limit_N_m.map(|limit| largest / limit);
        let whirl = backward_whirl.or(forward_whirl);
        let whirl = whirl.map_or(Severity::Ok, |_| whirl_severity(backward_whirl.is_some()));
        Lamps {
            stick_slip_severity: stick_slip
                .as_ref()
                .and_then(stick_slip_severity)
                .map(Severity::name),
            stick_slip: stick_slip.map(|of| StickSlipLamp {
                severity: of.severity,
                period_s: of.period_s,
                stuck_fraction: of.stuck_fraction,
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
