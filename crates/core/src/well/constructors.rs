//! Wells from the numbers that an engineer has: stations in degrees, casing and open hole.

use std::ops::Range;

use super::{
    Friction, Hole, HoleKind, HoleSection, Interpolation, Path, PathError, Station, TieIn, Well,
};

impl Station {
    /// A station at a measured depth, m, with inclination and azimuth in degrees.
    pub fn from_degrees(md_m: f64, inclination_deg: f64, azimuth_deg: f64) -> Self {
        Self {
            md_m,
            inclination_rad: inclination_deg.to_radians(),
            azimuth_rad: azimuth_deg.to_radians(),
        }
    }
}

impl Path {
    /// Circular arcs through stations, from the wellhead down.
    ///
    /// # Errors
    /// Those of [`Path::new`].
    pub fn minimum_curvature(stations: &[Station]) -> Result<Self, PathError> {
        Self::new(stations, Interpolation::MinimumCurvature, TieIn::default())
    }

    /// A curve with continuous curvature through stations, from the wellhead down: preferable for
    /// dynamics, which reacts to every jump of the curvature.
    ///
    /// # Errors
    /// Those of [`Path::new`].
    pub fn spline(stations: &[Station]) -> Result<Self, PathError> {
        Self::new(stations, Interpolation::Spline, TieIn::default())
    }
}

impl HoleSection {
    /// Casing over a range of measured depth, m, with its inside diameter, m, and a coefficient of
    /// friction.
    pub const fn casing(md_m: Range<f64>, diameter_m: f64, friction: f64) -> Self {
        Self::of_kind(HoleKind::Casing, md_m, diameter_m, friction)
    }

    /// Open hole over a range of measured depth, m, with its diameter, m, and a coefficient of
    /// friction.
    pub const fn open(md_m: Range<f64>, diameter_m: f64, friction: f64) -> Self {
        Self::of_kind(HoleKind::Open, md_m, diameter_m, friction)
    }

    const fn of_kind(kind: HoleKind, md_m: Range<f64>, diameter_m: f64, friction: f64) -> Self {
        let (youngs_modulus_Pa, poisson_ratio) = kind.elastic_constants();
        Self {
            kind,
            from_md_m: md_m.start,
            to_md_m: md_m.end,
            diameter_m,
            friction: Friction::uniform(friction),
            youngs_modulus_Pa,
            poisson_ratio,
            roughness: 1.0,
            casing: None,
        }
    }
}

impl Well {
    /// A path with the hole around it.
    pub const fn new(path: Path, hole: Hole) -> Self {
        Self { path, hole }
    }
}
