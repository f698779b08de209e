//! The numbers that are looked for.

use wholestring::well::{Friction, HoleKind};

use super::Motion;
use crate::WallFriction;

/// Friction factors of steel and of rock, along the hole and around it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Factors {
    /// In casing, along the hole.
    pub cased: f64,
    /// In open hole, along it.
    pub open: f64,
    /// In casing, around it.
    pub cased_around: f64,
    /// In open hole, around it.
    pub open_around: f64,
}

/// Smallest factor along the hole that one around it is taken in its ratio to.
const LEAST: f64 = 1e-6;

impl Factors {
    /// As a setup takes them.
    pub fn walls(&self) -> WallFriction {
        let friction = |along: f64, around: f64| {
            let along = if around > 0.0 { along.max(LEAST) } else { along };
            let ratio = if along > 0.0 { around / along } else { 1.0 };
            Friction { around: ratio, ..Friction::uniform(along) }
        };
        WallFriction {
            cased: friction(self.cased, self.cased_around),
            open: friction(self.open, self.open_around),
        }
    }
}

/// All that the readings depend on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// Friction.
    pub factors: Factors,
    /// Weight of block and top drive, N, which the weight indicator shows too.
    pub block_weight_N: f64,
    /// Torque of the bit on bottom, N·m.
    pub bit_torque_N_m: f64,
}

/// A number that can be looked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Parameter {
    /// Friction factor of all walls, along the hole.
    Friction,
    /// Of casing, along the hole.
    Cased,
    /// Of open hole, along it.
    Open,
    /// Of all walls, around the hole.
    FrictionAround,
    /// Of casing, around it.
    CasedAround,
    /// Of open hole, around it.
    OpenAround,
    /// Weight of block and top drive, N.
    BlockWeight,
    /// Torque of the bit on bottom, N·m.
    BitTorque,
}

impl Parameter {
    /// Every parameter.
    pub const ALL: [Self; 8] = [
        Self::Friction,
        Self::Cased,
        Self::Open,
        Self::FrictionAround,
        Self::CasedAround,
        Self::OpenAround,
        Self::BlockWeight,
        Self::BitTorque,
    ];

    /// Name in results, with its unit.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Friction => "friction",
            Self::Cased => "friction_cased",
            Self::Open => "friction_open",
            Self::FrictionAround => "friction_around",
            Self::CasedAround => "friction_cased_around",
            Self::OpenAround => "friction_open_around",
            Self::BlockWeight => "block_weight_N",
            Self::BitTorque => "bit_torque_N_m",
        }
    }

    /// The parameter of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|parameter| parameter.name() == name)
    }

    /// In a sentence.
    pub const fn words(self) -> &'static str {
        match self {
            Self::Friction => "friction factor",
            Self::Cased => "friction factor of casing",
            Self::Open => "friction factor of open hole",
            Self::FrictionAround => "friction factor around the hole",
            Self::CasedAround => "friction factor of casing around the hole",
            Self::OpenAround => "friction factor of open hole around the hole",
            Self::BlockWeight => "block weight",
            Self::BitTorque => "bit torque",
        }
    }

    /// Whether it is a friction factor.
    pub const fn is_factor(self) -> bool {
        !matches!(self, Self::BlockWeight | Self::BitTorque)
    }

    /// Whether it is a factor around the hole only.
    pub const fn is_around(self) -> bool {
        matches!(self, Self::FrictionAround | Self::CasedAround | Self::OpenAround)
    }

    /// The wall that it is of; none of all walls, and of what is no factor.
    pub const fn wall(self) -> Option<HoleKind> {
        match self {
            Self::Cased | Self::CasedAround => Some(HoleKind::Casing),
            Self::Open | Self::OpenAround => Some(HoleKind::Open),
            _ => None,
        }
    }

    /// Whether a string that moves so rubs by it; of one along the hole while it turns, only where
    /// the factor around follows it.
    pub(super) const fn rubs(self, motion: Motion, around_follows: bool) -> bool {
        self.is_factor()
            && match (self.is_around(), motion.turns()) {
                (around, true) => around || around_follows,
                (around, false) => !around,
            }
    }

    /// Sets it; a factor along the hole takes that around it along by its ratio, where it has one.
    pub(super) fn set(self, state: &mut State, value: f64, ratio: Option<[f64; 2]>) {
        let factors = &mut state.factors;
        if matches!(self, Self::Friction | Self::Cased) {
            factors.cased = value;
            factors.cased_around = ratio.map_or(factors.cased_around, |[of, _]| of * value);
        }
        if matches!(self, Self::Friction | Self::Open) {
            factors.open = value;
            factors.open_around = ratio.map_or(factors.open_around, |[_, of]| of * value);
        }
        match self {
            Self::FrictionAround => {
                (factors.cased_around, factors.open_around) = (value, value);
            }
            Self::CasedAround => factors.cased_around = value,
            Self::OpenAround => factors.open_around = value,
            Self::BlockWeight => state.block_weight_N = value,
            Self::BitTorque => state.bit_torque_N_m = value,
            _ => {}
        }
    }
}
