//! Whose loads a compression is compared with.

use serde::Serialize;

use super::shape::Shape;

/// Whose loads a compression is compared with, for the sinusoid and for the helix.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub enum Criterion {
    /// He and Kyllingstad: the sinusoid of Dawson and Paslay and the helix of Chen, Lin and
    /// Cheatham, pressed to the wall by the hole's curvature too.
    #[default]
    HeKyllingstad,
    /// Dawson and Paslay's sinusoid and Chen, Lin and Cheatham's helix, as in a straight hole.
    ChenLinCheatham,
    /// Dawson and Paslay's sinusoid and Wu and Juvkam-Wold's finished helix, as in a straight hole.
    WuJuvkamWold,
}

impl Criterion {
    /// The shapes whose loads it takes for the sinusoid and for the helix.
    pub const fn shapes(self) -> [Shape; 2] {
        let helix = match self {
            Self::HeKyllingstad | Self::ChenLinCheatham => Shape::Helical,
            Self::WuJuvkamWold => Shape::FullHelical,
        };
        [Shape::Sinusoidal, helix]
    }

    /// The shape that it takes for the helix.
    pub const fn helix(self) -> Shape {
        self.shapes()[1]
    }

    /// Whether the wall load from the hole's curvature is included.
    pub const fn counts_curvature(self) -> bool {
        matches!(self, Self::HeKyllingstad)
    }
}
