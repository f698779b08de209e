//! Interpolation of the hole's axis between survey stations.

use serde::Serialize;

/// Interpolation of the curve between stations.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum Interpolation {
    /// Circular arcs: the industry's standard. The curvature jumps at stations.
    MinimumCurvature,
    /// A curve with continuous curvature through the same directions.
    Spline,
}
