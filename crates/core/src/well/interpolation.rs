//! How the hole's axis runs between survey stations.

use serde::Serialize;

/// How the curve runs between stations.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum Interpolation {
    /// Circular arcs: the industry's standard. The curvature jumps at stations.
    MinimumCurvature,
    /// A curve with continuous curvature through the same directions.
    Spline,
}
