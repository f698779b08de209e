//! Registers of WebAssembly, two doubles or four singles each, in code that is compiled with
//! `simd128`.

use std::{
    arch::wasm32::*,
    ops::{Add, Div, Mul, Neg, Sub},
};

use super::number::{Doubles, Number};

macro_rules! v128_operator {
    ($name:ident, $trait:ident, $method:ident, $with:ident) => {
        impl $trait for $name {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self($with(self.0, other.0))
            }
        }
    };
}

macro_rules! v128_register {
    (
        $(#[$doc:meta])* $name:ident, $real:ty, $width:literal, $tiny:literal, $splat:ident,
        $add:ident, $sub:ident, $mul:ident, $div:ident, $neg:ident, $sqrt:ident,
        $max:ident, $min:ident, $greater:ident
    ) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy)]
        #[repr(transparent)]
        pub struct $name(v128);

        v128_operator!($name, Add, add, $add);
        v128_operator!($name, Sub, sub, $sub);
        v128_operator!($name, Mul, mul, $mul);
        v128_operator!($name, Div, div, $div);

        impl Neg for $name {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                Self($neg(self.0))
            }
        }

        impl Number for $name {
            type Real = $real;
            const WIDTH: usize = $width;
            const TINY: f64 = $tiny;
            #[inline(always)]
            fn splat(value: f64) -> Self {
                Self($splat(value as $real))
            }
            #[inline(always)]
            unsafe fn load(from: *const $real) -> Self {
                // SAFETY: the caller's `from` points to `WIDTH` numbers.
                unsafe { Self(v128_load(from.cast())) }
            }
            #[inline(always)]
            unsafe fn store(self, to: *mut $real) {
                // SAFETY: the caller's `to` points to `WIDTH` numbers.
                unsafe { v128_store(to.cast(), self.0) }
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                Self($sqrt(self.0))
            }
            #[inline(always)]
            fn mul_add(self, factor: Self, term: Self) -> Self {
                Self($add($mul(self.0, factor.0), term.0))
            }
            #[inline(always)]
            fn neg_mul_add(self, factor: Self, term: Self) -> Self {
                Self($sub(term.0, $mul(self.0, factor.0)))
            }
            // The second of these where neither is larger, or smaller, as the others do.
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                Self($max(other.0, self.0))
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                Self($min(other.0, self.0))
            }
            #[inline(always)]
            fn any_positive(self) -> bool {
                v128_any_true($greater(self.0, $splat(0.0)))
            }
            #[inline(always)]
            fn if_positive(self, then: Self, otherwise: Self) -> Self {
                Self(v128_bitselect(then.0, otherwise.0, $greater(self.0, $splat(0.0))))
            }
        }
    };
}

v128_register!(
    /// Two `f64`.
    V64, f64, 2, 1e-300, f64x2_splat,
    f64x2_add, f64x2_sub, f64x2_mul, f64x2_div, f64x2_neg, f64x2_sqrt,
    f64x2_pmax, f64x2_pmin, f64x2_gt
);
v128_register!(
    /// Four `f32`.
    V32, f32, 4, 1e-36, f32x4_splat,
    f32x4_add, f32x4_sub, f32x4_mul, f32x4_div, f32x4_neg, f32x4_sqrt,
    f32x4_pmax, f32x4_pmin, f32x4_gt
);

impl Doubles for V64 {
    #[inline(always)]
    unsafe fn widen(from: *const f32) -> Self {
        // SAFETY: the caller's `from` points to `WIDTH` numbers.
        unsafe { Self(f64x2_promote_low_f32x4(v128_load64_zero(from.cast()))) }
    }
    #[inline(always)]
    unsafe fn narrow(self, to: *mut f32) {
        // SAFETY: the caller's `to` points to room for `WIDTH` numbers.
        unsafe { v128_store64_lane::<0>(f32x4_demote_f64x2_zero(self.0), to.cast()) }
    }
}
