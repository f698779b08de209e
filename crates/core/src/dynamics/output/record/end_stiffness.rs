//! How elements resist being turned by an end.

use crate::simd::number::Doubles;

/// What turns an end of elements by one radian, N·m.
#[derive(Debug, Clone, Copy)]
pub struct EndStiffness<N> {
    /// Where the other end turns as much the other way: `EI/L` without tension.
    pub even: N,
    /// Where it turns as much the same way: `3 EI/L` without tension.
    pub odd: N,
    /// Moment half-way as one end turns.
    pub half_way: N,
}

impl<N: Doubles> EndStiffness<N> {
    /// While the other end stays as it is.
    #[inline(always)]
    pub fn held(&self) -> N {
        self.even + self.odd
    }

    /// Part of the moment of the end that turns which comes to the end that stays: half without
    /// tension.
    #[inline(always)]
    pub fn carry_over(&self) -> N {
        (self.odd - self.even) / self.held().max(N::splat(N::TINY))
    }
}
