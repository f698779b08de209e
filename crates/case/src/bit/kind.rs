//! Kinds of bits by name.

/// How a bit breaks rock.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Pdc,
    RollerCone,
    Core,
    Inserts,
}

impl Kind {
    pub(crate) const WORDS: &[(&str, Self)] = &[
        ("pdc", Self::Pdc),
        ("roller cone", Self::RollerCone),
        ("core", Self::Core),
        ("inserts", Self::Inserts),
    ];

    /// Inclination of the cutting force where the case does not say: the drag bit of Richard, Germay and Detournay's
    /// examples; of a roller cone `3/(4 · 0.25)`, such that its torque is 0.25 of `2aW/3`.
    pub(crate) fn inclination(self) -> f64 {
        match self {
            Self::RollerCone | Self::Inserts => 3.0,
            Self::Pdc | Self::Core => 0.6,
        }
    }

    /// Friction of the wear flats where the case does not say; teeth that roll rub half as much.
    pub(crate) fn friction(self) -> f64 {
        match self {
            Self::RollerCone | Self::Inserts => 0.3,
            Self::Pdc | Self::Core => 0.6,
        }
    }
}
