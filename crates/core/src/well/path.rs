//! The hole's axis as a curve through survey stations.

use nalgebra::Vector3;

use super::Station;

/// How the curve runs between stations.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interpolation {
    /// Circular arcs: the industry's standard. The curvature jumps at stations.
    MinimumCurvature,
    /// A curve with continuous curvature through the same directions.
    Spline,
}

/// Where the first station lies.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TieIn {
    /// North of the first station, m.
    pub north_m: f64,
    /// East of the first station, m.
    pub east_m: f64,
    /// True vertical depth of the first station, m.
    pub tvd_m: f64,
}

/// A point of the path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PathPoint {
    /// Position: north, east, down, m.
    pub position_m: Vector3<f64>,
    /// Unit tangent, towards the bit.
    pub tangent: Vector3<f64>,
    /// Curvature vector, the derivative of the tangent along the path, 1/m.
    pub curvature_per_m: Vector3<f64>,
}

/// Why stations make no path.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PathError {
    /// Fewer than two stations.
    #[error("a path needs at least two survey stations, got {0}")]
    TooFewStations(usize),
}

/// The hole's axis: position, direction and curvature at any measured depth.
#[derive(Debug, Clone)]
pub struct Path {
    stations: Vec<Station>,
}
