//! Lateral constraints at the ends of the string.

use serde::Serialize;

/// Lateral constraint of the top. It never leaves the hole's axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub enum TopEnd {
    /// Along the hole's axis: in the rotary table, in a packer.
    #[default]
    Clamped,
    /// Free to tilt.
    Pinned,
}

/// Lateral constraint of the bit. All but a free one touch no wall: the bit fills the hole that it
/// cuts.
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

/// Constraints of both ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Ends {
    /// The top.
    pub top: TopEnd,
    /// The bit.
    pub bit: BitEnd,
}

impl BitEnd {
    /// Stiffness that holds the bit to the hole's axis, N/m, with its own lateral stiffness;
    /// infinite where it does not leave the axis.
    pub(crate) fn stiffness_N_per_m(self, own_N_per_m: f64) -> f64 {
        match self {
            Self::Held => own_N_per_m,
            Self::Pinned | Self::Clamped => f64::INFINITY,
            Self::Free => 0.0,
        }
    }
}
