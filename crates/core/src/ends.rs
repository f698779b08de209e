//! How the ends of the string are held across the hole.

use serde::Serialize;

/// How the top is held. It never leaves the hole's axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub enum TopEnd {
    /// Along the hole's axis: in the rotary table, in a packer.
    #[default]
    Clamped,
    /// Free to tilt.
    Pinned,
}

/// How the bit is held. All but a free one touch no wall: the bit fills the hole that it cuts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub enum BitEnd {
    /// By its lateral stiffness, free to tilt.
    #[default]
    Held,
    /// On the hole's axis exactly, free to tilt.
    Pinned,
    /// On the hole's axis and along it: a long bit, a string that is cemented in.
    Clamped,
    /// By nothing but the wall, which it touches like any other part of the string.
    Free,
}

/// How both ends are held.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Ends {
    /// The top.
    pub top: TopEnd,
    /// The bit.
    pub bit: BitEnd,
}

impl BitEnd {
    /// What holds the bit to the hole's axis, N/m, by a lateral stiffness of its own: infinite
    /// where it does not leave it.
    pub(crate) fn stiffness_N_per_m(self, own_N_per_m: f64) -> f64 {
        match self {
            Self::Held => own_N_per_m,
            Self::Pinned | Self::Clamped => f64::INFINITY,
            Self::Free => 0.0,
        }
    }
}
