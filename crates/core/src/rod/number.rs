//! What the mechanics is written over.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A real number, with or without fused multiply-add.
///
/// The mechanics of an element, of a contact and of a node is written once over this trait: a plain
/// `f64` serves tests, the preparation of a run and processors without the fused form, [`Fused`] the
/// others. Nothing in it branches, so that the compiler can work on neighbours side by side.
pub trait Number:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// This value.
    fn splat(value: f64) -> Self;
    /// Its value.
    fn get(self) -> f64;
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

macro_rules! number {
    ($type:ty, $of:expr, $get:expr, $fused:literal) => {
        impl Number for $type {
            #[inline(always)]
            fn splat(value: f64) -> Self {
                $of(value)
            }
            #[inline(always)]
            fn get(self) -> f64 {
                $get(self)
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                $of($get(self).sqrt())
            }
            #[inline(always)]
            fn mul_add(self, factor: Self, term: Self) -> Self {
                if $fused {
                    $of($get(self).mul_add($get(factor), $get(term)))
                } else {
                    $of($get(self) * $get(factor) + $get(term))
                }
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                if $get(self) > $get(other) {
                    self
                } else {
                    other
                }
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                if $get(self) < $get(other) {
                    self
                } else {
                    other
                }
            }
            #[inline(always)]
            fn if_positive(self, then: Self, otherwise: Self) -> Self {
                if $get(self) > 0.0 { then } else { otherwise }
            }
        }
    };
}

/// An `f64` in code that is compiled for a processor with fused multiply-add. Without one,
/// `f64::mul_add` is a library call twenty times slower than a multiplication and an addition.
#[derive(Debug, Clone, Copy)]
pub struct Fused(f64);

macro_rules! fused_operator {
    ($trait:ident, $method:ident, $op:tt) => {
        impl $trait for Fused {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(self.0 $op other.0)
            }
        }
    };
}
fused_operator!(Add, add, +);
fused_operator!(Sub, sub, -);
fused_operator!(Mul, mul, *);
fused_operator!(Div, div, /);

impl Neg for Fused {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

number!(f64, |x: f64| x, |x: f64| x, false);
number!(Fused, Fused, |x: Fused| x.0, true);
