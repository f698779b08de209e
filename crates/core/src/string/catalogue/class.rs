//! Wear classes of drill pipe.

use serde::Serialize;

/// Class of a used drill pipe: how much of its wall is left.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum PipeClass {
    /// Nominal wall.
    #[default]
    New,
    /// 80 % of the nominal wall at least.
    Premium,
    /// 70 % of the nominal wall at least.
    #[serde(rename = "class 2")]
    Class2,
}

impl PipeClass {
    /// Every class, the best first.
    pub const ALL: [Self; 3] = [Self::New, Self::Premium, Self::Class2];

    /// The part of the nominal wall that is left at least, worn from outside (API RP 7G, tables 4
    /// to 7).
    pub const fn wall_left(self) -> f64 {
        match self {
            Self::New => 1.0,
            Self::Premium => 0.8,
            Self::Class2 => 0.7,
        }
    }

    /// Whether it has its nominal wall.
    pub const fn is_new(&self) -> bool {
        matches!(self, Self::New)
    }

    /// Suffix of a designation; empty for new pipe.
    pub const fn suffix(self) -> &'static str {
        match self {
            Self::New => "",
            Self::Premium => " premium",
            Self::Class2 => " class 2",
        }
    }
}
