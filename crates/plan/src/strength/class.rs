//! Classes of used drill pipe.

/// How much of its wall a drill pipe has left.
///
/// API RP 7G, tables of used drill pipe (as commonly printed): worn evenly on the outside, with 80 % of the
/// nominal wall left for premium class and 70 % for class 2.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum PipeClass {
    /// The nominal wall.
    #[default]
    New,
    /// At least 80 % of the wall.
    Premium,
    /// At least 70 % of the wall.
    Class2,
}

impl PipeClass {
    /// Every class, the best first.
    pub const ALL: [Self; 3] = [Self::New, Self::Premium, Self::Class2];

    /// Name in case files and results.
    pub const fn name(self) -> &'static str {
        match self {
            Self::New => "new",
            Self::Premium => "premium",
            Self::Class2 => "class 2",
        }
    }

    /// Part of the nominal wall that is left.
    pub const fn wall_left(self) -> f64 {
        match self {
            Self::New => 1.0,
            Self::Premium => 0.8,
            Self::Class2 => 0.7,
        }
    }
}
