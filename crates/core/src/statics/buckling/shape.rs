//! The shapes of a compressed pipe, and the loads at which it takes them.

use std::f64::consts::SQRT_2;

/// A shape that a compressed pipe may take, and whose load it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// The sinusoid: Dawson and Paslay, in a vertical hole Lubinski's first order.
    Sinusoidal,
    /// The helix as it begins: Chen, Lin and Cheatham.
    Helical,
    /// The finished helix: Wu and Juvkam-Wold.
    FullHelical,
}

impl Shape {
    /// `β` of `F² = β EI w_n/r`.
    pub fn beta(self) -> f64 {
        let root = match self {
            Self::Sinusoidal => 2.0,
            Self::Helical => 2.0 * SQRT_2,
            Self::FullHelical => 2.0 * (2.0 * SQRT_2 - 1.0),
        };
        root * root
    }

    /// Load over `(EI w²)^⅓` at the lower end of a long string in a vertical hole.
    pub(super) fn vertical(self) -> f64 {
        match self {
            Self::Sinusoidal => 1.94,
            Self::Helical | Self::FullHelical => 5.55,
        }
    }
}
