//! A stretch of steady motion, and what is picked of it.

use super::{estimate::Estimate, motion::Motion};

/// What a window is picked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Kind {
    /// The hook load while the string is pulled out without rotation.
    PickUp,
    /// The hook load while it is run in without rotation.
    SlackOff,
    /// Hook load and torque while it turns off bottom.
    Rotating,
    /// The torque while it drills.
    Drilling,
}

impl Kind {
    /// Every one, in the order of a table.
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

    /// What a motion is picked for; nothing of most.
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

/// A stretch of steady motion, and what was picked of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Window {
    /// What it was picked for.
    pub kind: Kind,
    /// The stand, counted from 1 as the log goes on.
    pub stand: usize,
    /// Where it begins, s.
    pub from_s: f64,
    /// Where it ends, s.
    pub to_s: f64,
    /// Measured depth of the bit in its middle, m.
    pub bit_depth_m: f64,
    /// Median speed of the block, positive upwards, m/s.
    pub speed_m_per_s: f64,
    /// Median rotary speed, rad/s; NaN where none was logged.
    pub rotary_rad_per_s: f64,
    /// Hook load with the block, N; none of drilling.
    pub weight_N: Option<Estimate>,
    /// Torque, N·m; none without rotation.
    pub torque_N_m: Option<Estimate>,
}

impl Window {
    /// How well it tells what it is picked for, against others of its kind: less is better.
    pub(super) fn error(&self) -> f64 {
        let of = if self.kind == Kind::Drilling { self.torque_N_m } else { self.weight_N };
        of.or(self.torque_N_m).map_or(f64::INFINITY, |of| of.standard_error)
    }
}

/// Why a stretch of steady motion was not picked.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Refusal {
    /// Too little is left when its beginning and its end are cut off.
    Short,
    /// The weight changes all along it.
    Settling,
    /// The weights spread too far.
    Unsteady,
    /// The sensor was silent for most of it.
    Silent,
    /// The rig shows weight on bit.
    OnBit,
    /// The hole does not get deeper.
    NotDeeper,
    /// The torque goes down to nothing at times.
    Swinging,
}

impl Refusal {
    /// In words.
    pub fn words(self) -> &'static str {
        match self {
            Refusal::Short => "too short once transients are cut off",
            Refusal::Settling => "the weight still changes",
            Refusal::Unsteady => "the weights spread too far",
            Refusal::Silent => "the sensor says nothing for most of it",
            Refusal::OnBit => "the rig shows weight on bit",
            Refusal::NotDeeper => "the hole gets no deeper",
            Refusal::Swinging => "the torque goes down to nothing at times",
        }
    }
}

/// A stretch that was not picked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Refused {
    /// What it would have been picked for.
    pub kind: Kind,
    /// Where it begins, s.
    pub from_s: f64,
    /// Where it ends, s.
    pub to_s: f64,
    /// Why not.
    pub why: Refusal,
}
