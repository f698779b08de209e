//! Buffers of a step for the current rows.

use super::{
    elements::{Pull, Strains},
    imbalance::Before,
    nodes::Prediction,
};
use crate::simd::number::Real;

/// Buffers of a step for the current rows. They are reused from step to step because allocating
/// them anew took a tenth of the step of a short region.
#[derive(Clone)]
pub(super) struct Scratch<R: Real> {
    pub(super) strains: Strains<R>,
    pub(super) prediction: Prediction<R>,
    pub(super) before: Before<R>,
    /// Of three rows of elements, in turn.
    pub(super) pulls: [Pull<R>; 3],
    /// Of the last row of elements.
    pub(super) last: Pull<R>,
}

impl<R: Real> Scratch<R> {
    pub(super) fn new() -> Self {
        Self {
            strains: Strains::none(),
            prediction: Prediction::none(),
            before: Before::none(),
            pulls: [Pull::none(); 3],
            last: Pull::none(),
        }
    }
}
