//! What the mechanics is written over: one number, or several side by side.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A real number, or a row of them treated alike.
///
/// The mechanics of an element, of a contact and of a node is written once over this trait; the
/// scalar form serves tests and the preparation of a run, the wide form the time loop.
pub trait Number:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The same value everywhere.
    fn splat(value: f64) -> Self;
    /// Square root.
    fn sqrt(self) -> Self;
    /// `self * factor + term`, fused where the processor has it and not otherwise.
    fn mul_add(self, factor: Self, term: Self) -> Self;
    /// Larger of the two.
    fn max(self, other: Self) -> Self;
    /// Smaller of the two.
    fn min(self, other: Self) -> Self;
    /// `then` where `self > 0`, `otherwise` elsewhere.
    fn if_positive(self, then: Self, otherwise: Self) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;

    /// Zero.
    #[inline(always)]
    fn zero() -> Self {
        Self::splat(0.0)
    }
    /// `term - self * factor`.
    #[inline(always)]
    fn neg_mul_add(self, factor: Self, term: Self) -> Self {
        (-self).mul_add(factor, term)
    }
}

impl Number for f64 {
    #[inline(always)]
    fn splat(value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, term: Self) -> Self {
        // `f64::mul_add` is a library call where the target has no fused form.
        self * factor + term
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        if self < other { self } else { other }
    }
    #[inline(always)]
    fn if_positive(self, then: Self, otherwise: Self) -> Self {
        if self > 0.0 { then } else { otherwise }
    }
    #[inline(always)]
    fn abs(self) -> Self {
        f64::abs(self)
    }
}
