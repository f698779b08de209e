//! A [`Number`] whose multiplications and additions stay apart.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::number::{Doubles, Number};

/// A number that multiplies and adds in two instructions even where the processor has one for both:
/// what is computed with it is the same, bit by bit, on every processor.
#[derive(Debug, Clone, Copy)]
#[repr(transparent)]
pub struct Apart<N>(N);

macro_rules! apart_operator {
    ($trait:ident, $method:ident) => {
        impl<N: Number> $trait for Apart<N> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0))
            }
        }
    };
}
apart_operator!(Add, add);
apart_operator!(Sub, sub);
apart_operator!(Mul, mul);
apart_operator!(Div, div);

impl<N: Number> Neg for Apart<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<N: Number> Number for Apart<N> {
    type Real = N::Real;
    const WIDTH: usize = N::WIDTH;
    const TINY: f64 = N::TINY;
    #[inline(always)]
    fn splat(value: f64) -> Self {
        Self(N::splat(value))
    }
    #[inline(always)]
    unsafe fn load(from: *const N::Real) -> Self {
        // SAFETY: the caller's.
        unsafe { Self(N::load(from)) }
    }
    #[inline(always)]
    unsafe fn store(self, to: *mut N::Real) {
        // SAFETY: the caller's.
        unsafe { self.0.store(to) }
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, term: Self) -> Self {
        self * factor + term
    }
    #[inline(always)]
    fn neg_mul_add(self, factor: Self, term: Self) -> Self {
        term - self * factor
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self(self.0.max(other.0))
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self(self.0.min(other.0))
    }
    #[inline(always)]
    fn if_positive(self, then: Self, otherwise: Self) -> Self {
        Self(self.0.if_positive(then.0, otherwise.0))
    }
    #[inline(always)]
    fn any_positive(self) -> bool {
        self.0.any_positive()
    }
}

impl<N: Doubles> Doubles for Apart<N> {
    #[inline(always)]
    unsafe fn widen(from: *const f32) -> Self {
        // SAFETY: the caller's.
        unsafe { Self(N::widen(from)) }
    }
    #[inline(always)]
    unsafe fn narrow(self, to: *mut f32) {
        // SAFETY: the caller's.
        unsafe { self.0.narrow(to) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simd::number::Fused;

    /// `(1 + ε)(1 − ε) − 1` is −ε² in one instruction and zero in two.
    #[test]
    fn a_product_is_rounded_before_it_is_added() {
        let [plus, minus, one] = [1.0 + f64::EPSILON, 1.0 - f64::EPSILON, 1.0];
        fn of<N: Number>(numbers: [f64; 3]) -> [f64; 2] {
            let [plus, minus, one] = numbers.map(N::splat);
            let kept = [plus.mul_add(minus, -one), plus.neg_mul_add(minus, one)];
            kept.map(|number| {
                let mut kept = [N::Real::default()];
                // SAFETY: there is room for the number.
                unsafe { number.store(kept.as_mut_ptr()) };
                crate::simd::number::Real::to_f64(kept[0])
            })
        }
        let square = f64::EPSILON * f64::EPSILON;
        assert_eq!(of::<Fused>([plus, minus, one]), [-square, square]);
        assert_eq!(of::<Apart<Fused>>([plus, minus, one]), [0.0, 0.0]);
    }
}
