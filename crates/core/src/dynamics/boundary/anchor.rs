//! Positions of the nodes' anchors on the hole's axis.

use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

use crate::{dynamics::kernel::chain::Chain, simd::number::Real};

/// Position of a node's anchor on the hole's axis.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub struct Anchor {
    /// Measured depth, m.
    pub md_m: f64,
    /// Position, m.
    pub position_m: Vector3<f64>,
    /// Unit vector across the axis towards the high side.
    pub high_side: Vector3<f64>,
}

/// Position of a node at the middle of the last step of its region, m; the step of the uppermost
/// region is `dt`.
pub fn middle_m(
    chain: &Chain<impl Real>,
    anchors: &[Anchor],
    index: usize,
    dt: f64,
) -> Vector3<f64> {
    anchors[index].position_m + Vector3::from(chain.displacement(index))
        - 0.5 * chain.step_s(index, dt) * Vector3::from(chain.velocity(index))
}
