//! Eight numbers side by side, in plain arrays that the compiler turns into vector instructions.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::number::Number;

/// How many elements are worked on at once: one 512-bit register of `f64`.
pub const LANES: usize = 8;

/// Eight numbers. `FUSED` says whether the code that uses them is compiled for a processor with
/// fused multiply-add; without one, `mul_add` would be a library call twenty times slower.
#[derive(Debug, Clone, Copy)]
#[repr(C, align(64))]
pub struct Lanes<const FUSED: bool>(pub [f64; LANES]);

impl<const FUSED: bool> Lanes<FUSED> {
    /// Reads eight numbers.
    #[inline(always)]
    pub fn load(from: &[f64; LANES]) -> Self {
        Self(*from)
    }

    /// The lanes one further on: lane `i` takes lane `i + 1`, the last takes `next`.
    #[inline(always)]
    pub fn shifted_down(self, next: f64) -> Self {
        let a = self.0;
        Self([a[1], a[2], a[3], a[4], a[5], a[6], a[7], next])
    }

    /// The lanes one back: lane `i` takes lane `i - 1`, the first takes `previous`.
    #[inline(always)]
    pub fn shifted_up(self, previous: f64) -> Self {
        let a = self.0;
        Self([previous, a[0], a[1], a[2], a[3], a[4], a[5], a[6]])
    }

    /// Sum over the lanes, always in the same order.
    #[inline(always)]
    pub fn sum(self) -> f64 {
        let a = self.0;
        ((a[0] + a[4]) + (a[2] + a[6])) + ((a[1] + a[5]) + (a[3] + a[7]))
    }
}

macro_rules! lane_operator {
    ($trait:ident, $method:ident, $op:tt) => {
        impl<const FUSED: bool> $trait for Lanes<FUSED> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                let mut out = self.0;
                for i in 0..LANES {
                    out[i] = self.0[i] $op other.0[i];
                }
                Self(out)
            }
        }
    };
}
lane_operator!(Add, add, +);
lane_operator!(Sub, sub, -);
lane_operator!(Mul, mul, *);
lane_operator!(Div, div, /);

impl<const FUSED: bool> Neg for Lanes<FUSED> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        let mut out = self.0;
        for x in &mut out {
            *x = -*x;
        }
        Self(out)
    }
}

impl<const FUSED: bool> Number for Lanes<FUSED> {
    #[inline(always)]
    fn splat(value: f64) -> Self {
        Self([value; LANES])
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        let mut out = self.0;
        for x in &mut out {
            *x = x.sqrt();
        }
        Self(out)
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, term: Self) -> Self {
        let mut out = self.0;
        for i in 0..LANES {
            out[i] = if FUSED {
                self.0[i].mul_add(factor.0[i], term.0[i])
            } else {
                self.0[i] * factor.0[i] + term.0[i]
            };
        }
        Self(out)
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        let mut out = self.0;
        for i in 0..LANES {
            out[i] = if self.0[i] > other.0[i] { self.0[i] } else { other.0[i] };
        }
        Self(out)
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        let mut out = self.0;
        for i in 0..LANES {
            out[i] = if self.0[i] < other.0[i] { self.0[i] } else { other.0[i] };
        }
        Self(out)
    }
    #[inline(always)]
    fn if_positive(self, then: Self, otherwise: Self) -> Self {
        let mut out = self.0;
        for i in 0..LANES {
            out[i] = if self.0[i] > 0.0 { then.0[i] } else { otherwise.0[i] };
        }
        Self(out)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        let mut out = self.0;
        for x in &mut out {
            *x = x.abs();
        }
        Self(out)
    }
}
