//! A stretch of steady motion and the values picked from it.

use super::{estimate::Estimate, motion::Motion};

/// Purpose of a window.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Kind {
    /// Hook load while the string is pulled out without rotation.
    PickUp,
    /// Hook load while the string is run in without rotation.
    SlackOff,
    /// Hook load and torque while the string turns off bottom.
    Rotating,
    /// Torque while drilling.
    Drilling,
}

impl Kind {
    /// Every kind, in the order of a table.
    pub const ALL: [Kind; 4] = [Kind::PickUp, Kind::SlackOff, Kind::Rotating, Kind::Drilling];

    /// In words.
    pub fn words(self) -> &'static str {
        match self {
            Kind::PickUp => "pick-up",
            Kind::SlackOff => "slack-off",
            Kind::Rotating => "rotating off bottom",
            Kind::Drilling => "drilling",
        }
    }

    /// Kind of window for a motion; `None` for most motions.
    pub(super) fn of(motion: Motion) -> Option<Self> {
        match motion {
            Motion::PickUp => Some(Kind::PickUp),
            Motion::SlackOff => Some(Kind::SlackOff),
            Motion::Rotating => Some(Kind::Rotating),
            Motion::Drilling => Some(Kind::Drilling),
            _ => None,
        }
    }
}

/// A stretch of steady motion and the values picked from it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Window {
    /// Kind of the window.
    pub kind: Kind,
    /// Number of the stand in the log, from 1.
    pub stand: usize,
    /// Start time, s.
    pub from_s: f64,
    /// End time, s.
    pub to_s: f64,
    /// Measured depth of the bit at the middle of the window, m.
    pub bit_depth_m: f64,
    /// Median speed of the block, positive upwards, m/s.
    pub speed_m_per_s: f64,
    /// Median rotary speed, rad/s; NaN if none was logged.
    pub rotary_rad_per_s: f64,
    /// Hook load including the block, N; `None` for drilling.
    pub weight_N: Option<Estimate>,
    /// Torque, N·m; `None` without rotation.
    pub torque_N_m: Option<Estimate>,
    /// Reason why the torque of a window with a weight was not picked.
    pub torque_refusal: Option<Refusal>,
}

impl Window {
    /// Standard error of its value, for comparison with windows of the same kind; less is better.
    pub(super) fn error(&self) -> f64 {
        let picked = if self.kind == Kind::Drilling { self.torque_N_m } else { self.weight_N };
        picked.or(self.torque_N_m).map_or(f64::INFINITY, |estimate| estimate.standard_error)
    }
}

/// Reason why a stretch of steady motion was not picked.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Refusal {
    /// Too little remains when its beginning and end are cut off.
    Short,
    /// The weight changes throughout.
    Settling,
    /// The spread of the weights is too large.
    Unsteady,
    /// The sensor had no value for most of it.
    Silent,
    /// The rig shows weight on bit.
    OnBit,
    /// The hole does not get deeper.
    NotDeeper,
    /// The torque drops to zero at times.
    Swinging,
}

impl Refusal {
    /// In words.
    pub fn words(self) -> &'static str {
        match self {
            Refusal::Short => "too short once transients are cut off",
            Refusal::Settling => "the weight still changes",
            Refusal::Unsteady => "the spread of the weights is too large",
            Refusal::Silent => "the sensor has no values for most of it",
            Refusal::OnBit => "the rig shows weight on bit",
            Refusal::NotDeeper => "the hole does not get deeper",
            Refusal::Swinging => "the torque drops to zero at times",
        }
    }
}

/// A stretch that was not picked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Refused {
    /// Kind of window that it would have been.
    pub kind: Kind,
    /// Start time, s.
    pub from_s: f64,
    /// End time, s.
    pub to_s: f64,
    /// The reason.
    pub why: Refusal,
}
