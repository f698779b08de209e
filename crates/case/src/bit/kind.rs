//! Kinds of bits by name.

/// How a bit breaks rock.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Pdc,
    RollerCone,
    Core,
    Inserts,
}

pub(crate) const PDC: &str = "pdc";
const ROLLER_CONE: &str = "roller cone";
pub(crate) const CORE: &str = "core";
pub(crate) const INSERTS: &str = "inserts";

impl Kind {
    pub(crate) const WORDS: &[(&str, Self)] = &[
        (PDC, Self::Pdc),
        (ROLLER_CONE, Self::RollerCone),
        (CORE, Self::Core),
        (INSERTS, Self::Inserts),
    ];

    /// Inclination of the cutting force where the case does not say: the drag bit of Richard,
    /// Germay and Detournay's examples; of a roller cone `3/(4 · 0.25)`, such that its torque is
    /// 0.25 of `2aW/3`.
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

    pub(crate) fn word(self) -> &'static str {
        let found = Self::WORDS.iter().find(|(_, kind)| *kind == self);
        found.map_or("", |(word, _)| word)
    }
}
