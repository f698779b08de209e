//! Friction, low, expected and high.

use serde::Serialize;
use wholestring::well::{Friction, FrictionLevel, HoleError, HoleKind, HoleSection};

use crate::Setup;

/// Friction of one kind of hole at one level.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub enum KindFriction {
    /// Each section's own coefficient along the hole plus this shift; the static one and the one
    /// around the hole keep their ratio to it. A negative shift does not go below
    /// [`KindFriction::LEAST`], or the section's own coefficient if that is less.
    Shifted(f64),
    /// The same for all sections of the kind.
    Given(Friction),
}

impl KindFriction {
    /// Default shift of low and high friction from the expected one: about the scatter of open-hole
    /// factors of one field.
    pub const USUAL_SHIFT: f64 = 0.1;

    /// Least coefficient that a negative shift leaves.
    pub const LEAST: f64 = 0.05;

    /// Returns `other` relative to this friction, where this one is given, instead of a section's
    /// own.
    fn beside(self, other: Self) -> Self {
        match self {
            Self::Given(friction) => Self::Given(other.of(&friction)),
            Self::Shifted(_) => other,
        }
    }

    /// Returns the friction of a section.
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
    /// Friction of casings and liners.
    pub cased: KindFriction,
    /// Friction of the rock.
    pub open: KindFriction,
}

impl LevelFriction {
    /// Returns every section's own friction plus a shift.
    pub const fn shifted(shift: f64) -> Self {
        Self { cased: KindFriction::Shifted(shift), open: KindFriction::Shifted(shift) }
    }

    /// Returns the same friction everywhere.
    pub const fn uniform(coefficient: f64) -> Self {
        let friction = KindFriction::Given(Friction::uniform(coefficient));
        Self { cased: friction, open: friction }
    }

    /// Returns `other` relative to this level, where this one is given, instead of each section's
    /// own friction.
    #[must_use]
    pub fn beside(&self, other: &Self) -> Self {
        Self { cased: self.cased.beside(other.cased), open: self.open.beside(other.open) }
    }

    /// Returns the friction of a section.
    pub fn of(&self, section: &HoleSection) -> Friction {
        match section.kind {
            HoleKind::Casing => self.cased.of(&section.friction),
            HoleKind::Open => self.open.of(&section.friction),
        }
    }

    /// Returns a string with this friction.
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
    /// Low friction.
    pub low: LevelFriction,
    /// Expected friction.
    pub expected: LevelFriction,
    /// High friction.
    pub high: LevelFriction,
}

impl Default for Frictions {
    /// Expected friction is the hole's own; low and high differ by [`KindFriction::USUAL_SHIFT`].
    fn default() -> Self {
        Self {
            low: LevelFriction::shifted(-KindFriction::USUAL_SHIFT),
            expected: LevelFriction::shifted(0.0),
            high: LevelFriction::shifted(KindFriction::USUAL_SHIFT),
        }
    }
}

impl Frictions {
    /// Returns the friction of a level.
    pub const fn of(&self, level: FrictionLevel) -> &LevelFriction {
        match level {
            FrictionLevel::Low => &self.low,
            FrictionLevel::Expected => &self.expected,
            FrictionLevel::High => &self.high,
        }
    }
}
