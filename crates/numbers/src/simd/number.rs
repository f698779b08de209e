//! Number types over which the mechanics is written.

use std::{
    fmt::Debug,
    ops::{Add, Div, IndexMut, Mul, Neg, Sub},
};

use serde::{Serialize, de::DeserializeOwned};

use super::lanes::{DOUBLES, SINGLES};

/// Storage type of a number.
pub trait Real: Number<Real = Self> + Default + PartialOrd + Debug + Send + Sync + 'static {
    /// Count of them in a row of nodes or elements.
    const LANES: usize;
    /// Whether the difference of two lengths of metres keeps the digits of a strain.
    const FINE: bool;
    /// So many of them.
    type Lanes: IndexMut<usize, Output = Self>
        + AsRef<[Self]>
        + AsMut<[Self]>
        + Copy
        + Debug
        + Send
        + Sync
        + Serialize
        + DeserializeOwned;
    /// The same in every lane.
    fn in_every_lane(self) -> Self::Lanes;
    /// The nearest to a double.
    fn from_f64(value: f64) -> Self;
    /// Its value.
    fn to_f64(self) -> f64;
    /// Several of them as doubles.
    ///
    /// # Safety
    /// `from` points to `D::WIDTH` numbers.
    unsafe fn doubles<D: Doubles>(from: *const Self) -> D;
    /// Keeps doubles, each as the nearest of these numbers.
    ///
    /// # Safety
    /// `to` points to room for `D::WIDTH` numbers.
    unsafe fn keep_doubles<D: Doubles>(doubles: D, to: *mut Self);
}

impl Real for f64 {
    const LANES: usize = DOUBLES;
    const FINE: bool = true;
    type Lanes = [Self; DOUBLES];
    #[inline(always)]
    fn in_every_lane(self) -> Self::Lanes {
        [self; Self::LANES]
    }
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        self
    }
    #[inline(always)]
    unsafe fn doubles<D: Doubles>(from: *const Self) -> D {
        // SAFETY: the caller's.
        unsafe { D::load(from) }
    }
    #[inline(always)]
    unsafe fn keep_doubles<D: Doubles>(doubles: D, to: *mut Self) {
        // SAFETY: the caller's.
        unsafe { doubles.store(to) }
    }
}

impl Real for f32 {
    const LANES: usize = SINGLES;
    const FINE: bool = false;
    type Lanes = [Self; SINGLES];
    #[inline(always)]
    fn in_every_lane(self) -> Self::Lanes {
        [self; Self::LANES]
    }
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        value as f32
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        f64::from(self)
    }
    #[inline(always)]
    unsafe fn doubles<D: Doubles>(from: *const Self) -> D {
        // SAFETY: the caller's.
        unsafe { D::widen(from) }
    }
    #[inline(always)]
    unsafe fn keep_doubles<D: Doubles>(doubles: D, to: *mut Self) {
        // SAFETY: the caller's.
        unsafe { doubles.narrow(to) }
    }
}

/// A real number, or several side by side.
///
/// Doubles round a product before they add to it: fused multiply-add is not on every processor, and
/// without it a case gives the same bits on all of them. Singles are there for speed and use it
/// where it is.
///
/// The mechanics of an element, of a contact and of a node is written once over this trait: a plain
/// `f64` or `f32` serves tests and the preparation of a run, the registers of a processor the time
/// loop. Nothing in it branches.
pub trait Number:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Storage type.
    type Real: Real;
    /// Far below any meaningful value, yet not zero, so that a quotient remains finite.
    const TINY: f64;
    /// This value, a constant.
    fn splat(value: f64) -> Self;
    /// Whether a product is added to before it is rounded.
    const FUSED: bool = false;
    /// Count of numbers in a register.
    const WIDTH: usize;
    /// From where it is kept.
    ///
    /// # Safety
    /// `from` points to `WIDTH` numbers.
    unsafe fn load(from: *const Self::Real) -> Self;
    /// To where it is kept.
    ///
    /// # Safety
    /// `to` points to `WIDTH` numbers.
    unsafe fn store(self, to: *mut Self::Real);
    /// Square root.
    fn sqrt(self) -> Self;
    /// `self * factor + term`: rounded twice, or once where it is [`Self::FUSED`].
    fn mul_add(self, factor: Self, term: Self) -> Self;
    /// Larger of the two.
    fn max(self, other: Self) -> Self;
    /// Smaller of the two.
    fn min(self, other: Self) -> Self;
    /// `then` where `self > 0`, `otherwise` elsewhere.
    fn if_positive(self, then: Self, otherwise: Self) -> Self;
    /// Whether one of the numbers at least is positive.
    fn any_positive(self) -> bool;
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

/// Doubles, which can be read from singles and kept as such.
pub trait Doubles: Number<Real = f64> {
    /// From where singles are kept.
    ///
    /// # Safety
    /// `from` points to `WIDTH` numbers.
    unsafe fn widen(from: *const f32) -> Self;
    /// To where singles are kept: the nearest ones.
    ///
    /// # Safety
    /// `to` points to room for `WIDTH` numbers.
    unsafe fn narrow(self, to: *mut f32);
}

impl Doubles for f64 {
    #[inline(always)]
    unsafe fn widen(from: *const f32) -> Self {
        // SAFETY: the caller's `from` points to a number.
        unsafe { Self::from(*from) }
    }
    #[inline(always)]
    unsafe fn narrow(self, to: *mut f32) {
        // SAFETY: the caller's `to` points to room for a number.
        unsafe { *to = self as f32 }
    }
}

macro_rules! number {
    ($type:ty, $real:ty, $tiny:literal, $of:expr, $get:expr, $fused:literal) => {
        impl Number for $type {
            type Real = $real;
            const FUSED: bool = $fused;
            const TINY: f64 = $tiny;
            const WIDTH: usize = 1;
            #[inline(always)]
            fn splat(value: f64) -> Self {
                $of(value as $real)
            }
            #[inline(always)]
            unsafe fn load(from: *const $real) -> Self {
                // SAFETY: the caller's `from` points to a number.
                unsafe { $of(*from) }
            }
            #[inline(always)]
            unsafe fn store(self, to: *mut $real) {
                // SAFETY: the caller's `to` points to a number.
                unsafe { *to = $get(self) }
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                $of($get(self).sqrt())
            }
            // Where it is fused, the code is compiled for a processor with the instruction.
            #[allow(clippy::disallowed_methods)]
            #[inline(always)]
            fn mul_add(self, factor: Self, term: Self) -> Self {
                if Self::FUSED {
                    $of($get(self).mul_add($get(factor), $get(term)))
                } else {
                    $of($get(self) * $get(factor) + $get(term))
                }
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                if $get(self) > $get(other) { self } else { other }
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                if $get(self) < $get(other) { self } else { other }
            }
            #[inline(always)]
            fn any_positive(self) -> bool {
                $get(self) > 0.0
            }
            #[inline(always)]
            fn if_positive(self, then: Self, otherwise: Self) -> Self {
                if $get(self) > 0.0 { then } else { otherwise }
            }
        }
    };
}

/// A single in code that is compiled for a processor with fused multiply-add. Without one,
/// `mul_add` is a library call twenty times slower than a multiplication and an addition.
#[derive(Debug, Clone, Copy)]
pub struct Fused(f32);

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

number!(f64, f64, 1e-300, |x: f64| x, |x: f64| x, false);
number!(f32, f32, 1e-36, |x: f32| x, |x: f32| x, false);
number!(Fused, f32, 1e-36, Fused, |x: Fused| x.0, true);
