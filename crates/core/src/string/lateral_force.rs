//! A force across the string.

use serde::Serialize;

/// A force across a component, fixed in space: of a rotary steerable, whose pads are controlled to
/// a direction while the tool turns.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LateralForce {
    /// Force on the tool, N; its pads press the wall on the other side by as much.
    pub force_N: f64,
    /// Distance of the force from the component's lower end, m.
    pub from_lower_end_m: f64,
    /// Direction to which the tool is pushed, rad from the high side at the bit, clockwise as one
    /// looks down the hole.
    pub toolface_rad: f64,
}
