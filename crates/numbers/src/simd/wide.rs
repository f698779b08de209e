//! [`Number`]s that are several numbers at once: one register of the processor, or two.
//!
//! The compiler widens a loop over plain numbers, too, but the quality depends on every line: some
//! loops were compiled with gathers, some with half the registers' width. The code here maps
//! directly to the processor's instructions.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::number::{Doubles, Fused, Number, Real};

/// Registers of a kind of number: for code that is compiled for a processor and runs where it is
/// that one.
///
/// The operators of a register are safe to write and sound only in such code, so that neither they
/// nor the ways to them leave this crate.
pub trait Registers: Real {
    /// One of them, on a processor that has fused multiply-add.
    type Scalar: Number<Real = Self>;
    /// A register of AVX-512.
    #[cfg(target_arch = "x86_64")]
    type Zmm: Number<Real = Self>;
    /// A register of AVX2.
    #[cfg(target_arch = "x86_64")]
    type Ymm: Number<Real = Self>;
    /// A register of any x86-64.
    #[cfg(target_arch = "x86_64")]
    type Xmm: Number<Real = Self>;
    /// A register of WebAssembly.
    #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
    type V128: Number<Real = Self>;
}

impl Registers for f64 {
    type Scalar = Self;
    #[cfg(target_arch = "x86_64")]
    type Zmm = x86::Zmm64;
    #[cfg(target_arch = "x86_64")]
    type Ymm = x86::Ymm64;
    #[cfg(target_arch = "x86_64")]
    type Xmm = x86::Xmm64;
    #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
    type V128 = super::wasm::V64;
}

impl Registers for f32 {
    type Scalar = Fused;
    #[cfg(target_arch = "x86_64")]
    type Zmm = x86::Zmm32;
    #[cfg(target_arch = "x86_64")]
    type Ymm = x86::Ymm32;
    #[cfg(target_arch = "x86_64")]
    type Xmm = x86::Xmm32;
    #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
    type V128 = super::wasm::V32;
}

/// Two of them, worked on in turn: while the processor waits for the one, it works on the other.
#[derive(Debug, Clone, Copy)]
pub struct Pair<N>(N, N);

/// Whether the processor has the instructions of code for AVX2: AVX2, and fused multiply-add for
/// singles.
#[cfg(target_arch = "x86_64")]
pub fn has_avx2() -> bool {
    is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma")
}

/// Whether it has the instructions of code for AVX-512, AVX2's included.
#[cfg(target_arch = "x86_64")]
pub fn has_avx512() -> bool {
    has_avx2()
        && is_x86_feature_detected!("avx512f")
        && is_x86_feature_detected!("avx512dq")
        && is_x86_feature_detected!("avx512vl")
}

macro_rules! pair_operator {
    ($trait:ident, $method:ident) => {
        impl<N: Number> $trait for Pair<N> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0), self.1.$method(other.1))
            }
        }
    };
}
pair_operator!(Add, add);
pair_operator!(Sub, sub);
pair_operator!(Mul, mul);
pair_operator!(Div, div);

impl<N: Number> Neg for Pair<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}

impl<N: Number> Number for Pair<N> {
    type Real = N::Real;
    const FUSED: bool = N::FUSED;
    const WIDTH: usize = 2 * N::WIDTH;
    const TINY: f64 = N::TINY;
    #[inline(always)]
    fn splat(value: f64) -> Self {
        Self(N::splat(value), N::splat(value))
    }
    #[inline(always)]
    unsafe fn load(from: *const N::Real) -> Self {
        // SAFETY: the caller's `from` points to `WIDTH` numbers.
        unsafe { Self(N::load(from), N::load(from.add(N::WIDTH))) }
    }
    #[inline(always)]
    unsafe fn store(self, to: *mut N::Real) {
        // SAFETY: the caller's `to` points to `WIDTH` numbers.
        unsafe {
            self.0.store(to);
            self.1.store(to.add(N::WIDTH));
        }
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt(), self.1.sqrt())
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, term: Self) -> Self {
        Self(self.0.mul_add(factor.0, term.0), self.1.mul_add(factor.1, term.1))
    }
    #[inline(always)]
    fn neg_mul_add(self, factor: Self, term: Self) -> Self {
        Self(self.0.neg_mul_add(factor.0, term.0), self.1.neg_mul_add(factor.1, term.1))
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self(self.0.max(other.0), self.1.max(other.1))
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self(self.0.min(other.0), self.1.min(other.1))
    }
    #[inline(always)]
    fn any_positive(self) -> bool {
        // Both are computed: a branch between them would be one more to predict.
        self.0.any_positive() | self.1.any_positive()
    }
    #[inline(always)]
    fn if_positive(self, then: Self, otherwise: Self) -> Self {
        Self(self.0.if_positive(then.0, otherwise.0), self.1.if_positive(then.1, otherwise.1))
    }
}

impl<N: Doubles> Doubles for Pair<N> {
    #[inline(always)]
    unsafe fn widen(from: *const f32) -> Self {
        // SAFETY: the caller's `from` points to `WIDTH` numbers.
        unsafe { Self(N::widen(from), N::widen(from.add(N::WIDTH))) }
    }
    #[inline(always)]
    unsafe fn narrow(self, to: *mut f32) {
        // SAFETY: the caller's `to` points to room for `WIDTH` numbers.
        unsafe {
            self.0.narrow(to);
            self.1.narrow(to.add(N::WIDTH));
        }
    }
}

/// Registers of x86.
///
/// Their operations are compiled into code of the same instruction set and nowhere else: a value
/// exists only inside a step that the processor was found to be able to run.
#[cfg(target_arch = "x86_64")]
mod x86 {
    // The intrinsics have the processor's names.
    #![allow(missing_docs)]

    use std::{
        arch::x86_64::*,
        ops::{Add, Div, Mul, Neg, Sub},
    };

    use super::{Doubles, Number};

    macro_rules! operator {
        ($name:ident, $trait:ident, $method:ident, $with:ident) => {
            impl $trait for $name {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: Self) -> Self {
                    // SAFETY: see the module.
                    unsafe { Self($with(self.0, other.0)) }
                }
            }
        };
    }

    macro_rules! register {
        (
            $(#[$doc:meta])* $name:ident, $register:ty, $real:ty, $width:literal, $tiny:literal,
            $set1:ident, $load:ident, $store:ident,
            $add:ident, $sub:ident, $mul:ident, $div:ident, $sqrt:ident, $max:ident, $min:ident,
            $fused:literal, |$a:ident, $b:ident, $c:ident| $fma:expr, $fnma:expr, |$x:ident, $then:ident, $otherwise:ident| $select:expr,
            |$any_x:ident| $any:expr
        ) => {
            $(#[$doc])*
            #[derive(Debug, Clone, Copy)]
            #[repr(transparent)]
            pub struct $name($register);

            operator!($name, Add, add, $add);
            operator!($name, Sub, sub, $sub);
            operator!($name, Mul, mul, $mul);
            operator!($name, Div, div, $div);

            impl Neg for $name {
                type Output = Self;
                #[inline(always)]
                fn neg(self) -> Self {
                    // SAFETY: see the module.
                    unsafe { Self($sub($set1(-0.0), self.0)) }
                }
            }

            impl Number for $name {
                type Real = $real;
                const FUSED: bool = $fused;
                const WIDTH: usize = $width;
                const TINY: f64 = $tiny;
                #[inline(always)]
                fn splat(value: f64) -> Self {
                    // SAFETY: see the module.
                    unsafe { Self($set1(value as $real)) }
                }
                #[inline(always)]
                unsafe fn load(from: *const $real) -> Self {
                    // SAFETY: the caller's `from` points to `WIDTH` numbers.
                    unsafe { Self($load(from)) }
                }
                #[inline(always)]
                unsafe fn store(self, to: *mut $real) {
                    // SAFETY: the caller's `to` points to `WIDTH` numbers.
                    unsafe { $store(to, self.0) }
                }
                #[inline(always)]
                fn sqrt(self) -> Self {
                    // SAFETY: see the module.
                    unsafe { Self($sqrt(self.0)) }
                }
                #[inline(always)]
                fn mul_add(self, factor: Self, term: Self) -> Self {
                    let ($a, $b, $c) = (self.0, factor.0, term.0);
                    // SAFETY: see the module.
                    unsafe { Self($fma) }
                }
                #[inline(always)]
                fn neg_mul_add(self, factor: Self, term: Self) -> Self {
                    let ($a, $b, $c) = (self.0, factor.0, term.0);
                    // SAFETY: see the module.
                    unsafe { Self($fnma) }
                }
                #[inline(always)]
                fn max(self, other: Self) -> Self {
                    // SAFETY: see the module.
                    unsafe { Self($max(self.0, other.0)) }
                }
                #[inline(always)]
                fn min(self, other: Self) -> Self {
                    // SAFETY: see the module.
                    unsafe { Self($min(self.0, other.0)) }
                }
                #[inline(always)]
                fn any_positive(self) -> bool {
                    let $any_x = self.0;
                    // SAFETY: see the module.
                    unsafe { $any }
                }
                #[inline(always)]
                fn if_positive(self, then: Self, otherwise: Self) -> Self {
                    let ($x, $then, $otherwise) = (self.0, then.0, otherwise.0);
                    // SAFETY: see the module.
                    unsafe { Self($select) }
                }
            }
        };
    }

    register!(
        /// Eight `f64`: AVX-512.
        Zmm64, __m512d, f64, 8, 1e-300,
        _mm512_set1_pd, _mm512_loadu_pd, _mm512_storeu_pd,
        _mm512_add_pd, _mm512_sub_pd, _mm512_mul_pd, _mm512_div_pd, _mm512_sqrt_pd, _mm512_max_pd, _mm512_min_pd,
        false, |a, b, c| _mm512_add_pd(_mm512_mul_pd(a, b), c), _mm512_sub_pd(c, _mm512_mul_pd(a, b)),
        |x, then, otherwise| {
            let mask = _mm512_cmp_pd_mask::<_CMP_GT_OQ>(x, _mm512_setzero_pd());
            _mm512_mask_blend_pd(mask, otherwise, then)
        },
        |x| _mm512_cmp_pd_mask::<_CMP_GT_OQ>(x, _mm512_setzero_pd()) != 0
    );
    register!(
        /// Sixteen `f32`: AVX-512.
        Zmm32, __m512, f32, 16, 1e-36,
        _mm512_set1_ps, _mm512_loadu_ps, _mm512_storeu_ps,
        _mm512_add_ps, _mm512_sub_ps, _mm512_mul_ps, _mm512_div_ps, _mm512_sqrt_ps, _mm512_max_ps, _mm512_min_ps,
        true, |a, b, c| _mm512_fmadd_ps(a, b, c), _mm512_fnmadd_ps(a, b, c),
        |x, then, otherwise| {
            let mask = _mm512_cmp_ps_mask::<_CMP_GT_OQ>(x, _mm512_setzero_ps());
            _mm512_mask_blend_ps(mask, otherwise, then)
        },
        |x| _mm512_cmp_ps_mask::<_CMP_GT_OQ>(x, _mm512_setzero_ps()) != 0
    );
    register!(
        /// Four `f64`: AVX2.
        Ymm64, __m256d, f64, 4, 1e-300,
        _mm256_set1_pd, _mm256_loadu_pd, _mm256_storeu_pd,
        _mm256_add_pd, _mm256_sub_pd, _mm256_mul_pd, _mm256_div_pd, _mm256_sqrt_pd, _mm256_max_pd, _mm256_min_pd,
        false, |a, b, c| _mm256_add_pd(_mm256_mul_pd(a, b), c), _mm256_sub_pd(c, _mm256_mul_pd(a, b)),
        |x, then, otherwise| {
            let mask = _mm256_cmp_pd::<_CMP_GT_OQ>(x, _mm256_setzero_pd());
            _mm256_blendv_pd(otherwise, then, mask)
        },
        |x| _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_GT_OQ>(x, _mm256_setzero_pd())) != 0
    );
    register!(
        /// Eight `f32`: AVX2 with FMA.
        Ymm32, __m256, f32, 8, 1e-36,
        _mm256_set1_ps, _mm256_loadu_ps, _mm256_storeu_ps,
        _mm256_add_ps, _mm256_sub_ps, _mm256_mul_ps, _mm256_div_ps, _mm256_sqrt_ps, _mm256_max_ps, _mm256_min_ps,
        true, |a, b, c| _mm256_fmadd_ps(a, b, c), _mm256_fnmadd_ps(a, b, c),
        |x, then, otherwise| {
            let mask = _mm256_cmp_ps::<_CMP_GT_OQ>(x, _mm256_setzero_ps());
            _mm256_blendv_ps(otherwise, then, mask)
        },
        |x| _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_GT_OQ>(x, _mm256_setzero_ps())) != 0
    );
    register!(
        /// Two `f64`: every x86-64.
        Xmm64, __m128d, f64, 2, 1e-300,
        _mm_set1_pd, _mm_loadu_pd, _mm_storeu_pd,
        _mm_add_pd, _mm_sub_pd, _mm_mul_pd, _mm_div_pd, _mm_sqrt_pd, _mm_max_pd, _mm_min_pd,
        false, |a, b, c| _mm_add_pd(_mm_mul_pd(a, b), c), _mm_sub_pd(c, _mm_mul_pd(a, b)),
        |x, then, otherwise| {
            let mask = _mm_cmpgt_pd(x, _mm_setzero_pd());
            _mm_or_pd(_mm_and_pd(mask, then), _mm_andnot_pd(mask, otherwise))
        },
        |x| _mm_movemask_pd(_mm_cmpgt_pd(x, _mm_setzero_pd())) != 0
    );
    register!(
        /// Four `f32`: every x86-64.
        Xmm32, __m128, f32, 4, 1e-36,
        _mm_set1_ps, _mm_loadu_ps, _mm_storeu_ps,
        _mm_add_ps, _mm_sub_ps, _mm_mul_ps, _mm_div_ps, _mm_sqrt_ps, _mm_max_ps, _mm_min_ps,
        false, |a, b, c| _mm_add_ps(_mm_mul_ps(a, b), c), _mm_sub_ps(c, _mm_mul_ps(a, b)),
        |x, then, otherwise| {
            let mask = _mm_cmpgt_ps(x, _mm_setzero_ps());
            _mm_or_ps(_mm_and_ps(mask, then), _mm_andnot_ps(mask, otherwise))
        },
        |x| _mm_movemask_ps(_mm_cmpgt_ps(x, _mm_setzero_ps())) != 0
    );

    macro_rules! widened {
        ($name:ident, |$from:ident| $widen:expr, |$x:ident, $to:ident| $narrow:expr) => {
            impl Doubles for $name {
                #[inline(always)]
                unsafe fn widen($from: *const f32) -> Self {
                    // SAFETY: see the module; the caller's `from` points to `WIDTH` numbers.
                    unsafe { Self($widen) }
                }
                #[inline(always)]
                unsafe fn narrow(self, $to: *mut f32) {
                    let $x = self.0;
                    // SAFETY: see the module; the caller's `to` points to room for them.
                    unsafe { $narrow }
                }
            }
        };
    }
    widened!(Zmm64, |from| _mm512_cvtps_pd(_mm256_loadu_ps(from)), |x, to| _mm256_storeu_ps(
        to,
        _mm512_cvtpd_ps(x)
    ));
    widened!(Ymm64, |from| _mm256_cvtps_pd(_mm_loadu_ps(from)), |x, to| _mm_storeu_ps(
        to,
        _mm256_cvtpd_ps(x)
    ));
    widened!(Xmm64, |from| _mm_cvtps_pd(_mm_castpd_ps(_mm_load_sd(from.cast()))), |x, to| {
        _mm_store_sd(to.cast(), _mm_castps_pd(_mm_cvtpd_ps(x)))
    });
}
