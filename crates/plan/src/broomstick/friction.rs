//! Friction, low, expected and high.

use serde::Serialize;
use wholestring::well::{Friction, HoleError, HoleKind, HoleSection};

use crate::Setup;

/// How much friction there is, of what there may be.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
pub enum FrictionLevel {
    /// Less than expected.
    Low,
    /// What is expected.
    Expected,
    /// More than expected.
    High,
}

impl FrictionLevel {
    /// Every level, from the least friction to the most.
    pub const ALL: [Self; 3] = [Self::Low, Self::Expected, Self::High];

    /// Name in case files and results.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Low => "low",
            Self::Expected => "expected",
            Self::High => "high",
        }
    }
}

/// Friction of one kind of hole at one level.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub enum KindFriction {
    /// Each section's own coefficient along the hole and so much more; those at rest and around the
    /// hole stay in their ratio to it. What is taken away leaves [`KindFriction::LEAST`], or what
    /// the section has if that is less.
    Shifted(f64),
    /// The same for all sections of the kind.
    Given(Friction),
}

impl KindFriction {
    /// How much low and high friction differ from what is expected where nothing else is said: about
    /// what open-hole factors of one field scatter by.
    pub const USUAL_SHIFT: f64 = 0.1;

    /// Less than this no hole is taken to rub by taking away.
    pub const LEAST: f64 = 0.05;

    /// As another one is beside a section's own, beside this one.
    fn beside(self, other: Self) -> Self {
        match self {
            Self::Given(friction) => Self::Given(other.of(&friction)),
            Self::Shifted(_) => other,
        }
    }

    /// The friction of a section.
    pub fn of(&self, own: &Friction) -> Friction {
        match *self {
            Self::Given(friction) => friction,
            Self::Shifted(0.0) => *own,
            Self::Shifted(shift) => {
                let least = Self::LEAST.min(own.kinetic);
                let kinetic = (own.kinetic + shift).max(least);
                // A section without friction has no ratio to keep.
                let at_rest = if own.kinetic > 0.0 { own.at_rest / own.kinetic } else { 1.0 };
                Friction { kinetic, at_rest: kinetic * at_rest, around: own.around }
            }
        }
    }
}

/// Friction of a well at one level.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LevelFriction {
    /// Of casings and liners.
    pub cased: KindFriction,
    /// Of the rock.
    pub open: KindFriction,
}

impl LevelFriction {
    /// Every section's own, and so much more.
    pub const fn shifted(shift: f64) -> Self {
        Self { cased: KindFriction::Shifted(shift), open: KindFriction::Shifted(shift) }
    }

    /// The same everywhere.
    pub const fn uniform(coefficient: f64) -> Self {
        let friction = KindFriction::Given(Friction::uniform(coefficient));
        Self { cased: friction, open: friction }
    }

    /// As another level is beside each section's own friction, beside this one.
    #[must_use]
    pub fn beside(&self, other: &Self) -> Self {
        Self { cased: self.cased.beside(other.cased), open: self.open.beside(other.open) }
    }

    /// The friction of a section.
    pub fn of(&self, section: &HoleSection) -> Friction {
        match section.kind {
            HoleKind::Casing => self.cased.of(&section.friction),
            HoleKind::Open => self.open.of(&section.friction),
        }
    }

    /// A string with this friction.
    ///
    /// # Errors
    /// A factor that is out of its range.
    pub fn applied_to(&self, setup: &Setup) -> Result<Setup, HoleError> {
        setup.with_friction_of(|section| self.of(section))
    }
}

/// Friction of a well at every level.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Frictions {
    /// The least.
    pub low: LevelFriction,
    /// What is expected.
    pub expected: LevelFriction,
    /// The most.
    pub high: LevelFriction,
}

impl Default for Frictions {
    /// Expected is what the hole has; low and high differ by [`KindFriction::USUAL_SHIFT`].
    fn default() -> Self {
        Self {
            low: LevelFriction::shifted(-KindFriction::USUAL_SHIFT),
            expected: LevelFriction::shifted(0.0),
            high: LevelFriction::shifted(KindFriction::USUAL_SHIFT),
        }
    }
}

impl Frictions {
    /// The friction of a level.
    pub const fn of(&self, level: FrictionLevel) -> &LevelFriction {
        match level {
            FrictionLevel::Low => &self.low,
            FrictionLevel::Expected => &self.expected,
            FrictionLevel::High => &self.high,
        }
    }
}
