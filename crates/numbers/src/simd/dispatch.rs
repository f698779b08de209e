//! The instruction sets that kernels are compiled for, and the choice between them while the
//! program runs.

#[cfg(not(any(
    target_arch = "x86_64",
    all(target_arch = "wasm32", target_feature = "simd128")
)))]
use super::wide::Pair;
#[cfg(any(
    target_arch = "x86_64",
    target_arch = "aarch64",
    all(target_arch = "wasm32", target_feature = "simd128")
))]
use super::wide::Registers;

/// Number type of a kernel in code for AVX-512.
#[cfg(target_arch = "x86_64")]
pub type Avx512<R> = <R as Registers>::Zmm;

/// Number type in code for AVX2.
#[cfg(target_arch = "x86_64")]
pub type Avx2<R> = <R as Registers>::Ymm;

/// Number type in code for every processor of the target.
#[cfg(target_arch = "x86_64")]
pub type Baseline<R> = <R as Registers>::Xmm;
/// Number type in code for every processor of the target.
#[cfg(target_arch = "aarch64")]
pub type Baseline<R> = Pair<<R as Registers>::Scalar>;
/// Number type in code for every processor of the target.
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
pub type Baseline<R> = <R as Registers>::V128;
/// Number type in code for every processor of the target.
#[cfg(not(any(
    target_arch = "x86_64",
    target_arch = "aarch64",
    all(target_arch = "wasm32", target_feature = "simd128")
)))]
pub type Baseline<R> = Pair<R>;

/// Expands a macro once for each instruction set of the target, with the name of a module, the type
/// of this file that its code computes with and
/// the features that it is compiled with, if it needs any.
#[doc(hidden)]
#[macro_export]
macro_rules! for_each_instruction_set {
    ($compile:ident) => {
        #[cfg(target_arch = "x86_64")]
        $compile!(avx512, Avx512, "avx512f,avx512dq,avx512vl,avx2,fma");
        #[cfg(target_arch = "x86_64")]
        $compile!(avx2, Avx2, "avx2,fma");
        $compile!(baseline, Baseline);
    };
}

/// Expands a macro for the module and the name of each instruction set that this processor has, the
/// fastest first; the baseline always is the last.
#[doc(hidden)]
#[macro_export]
macro_rules! available_instruction_sets {
    ($entry:ident) => {{
        let mut all = Vec::new();
        #[cfg(target_arch = "x86_64")]
        {
            if $crate::simd::wide::has_avx512() {
                all.push($entry!(avx512, "AVX-512"));
            }
            if $crate::simd::wide::has_avx2() {
                all.push($entry!(avx2, "AVX2"));
            }
        }
        all.push($entry!(baseline, "baseline"));
        all
    }};
}

/// Calls a function of the module of the fastest instruction set that this processor has.
#[doc(hidden)]
#[macro_export]
macro_rules! with_fastest_instruction_set {
    ($function:ident($($argument:expr),* $(,)?)) => {{
        #[cfg(target_arch = "x86_64")]
        let done = if $crate::simd::wide::has_avx512() {
            // SAFETY: the processor has the instructions for which the function is compiled.
            unsafe { avx512::$function($($argument),*) }
        } else if $crate::simd::wide::has_avx2() {
            // SAFETY: as above.
            unsafe { avx2::$function($($argument),*) }
        } else {
            baseline::$function($($argument),*)
        };
        #[cfg(not(target_arch = "x86_64"))]
        let done = baseline::$function($($argument),*);
        done
    }};
}

pub use {available_instruction_sets, for_each_instruction_set, with_fastest_instruction_set};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simd::number::{Number, Real};

    /// `(1 + ε)(1 − ε) − 1`, and its negative: ε² where the product is not rounded, else zero.
    #[inline(always)]
    fn kept<N: Number>(epsilon: f64) -> [f64; 2] {
        let [plus, minus, one] = [1.0 + epsilon, 1.0 - epsilon, 1.0].map(N::splat);
        [plus.mul_add(minus, -one), plus.neg_mul_add(minus, one)].map(|number| {
            let mut lanes = vec![N::Real::default(); N::WIDTH];
            // SAFETY: there is room for the numbers.
            unsafe { number.store(lanes.as_mut_ptr()) };
            lanes[0].to_f64()
        })
    }

    macro_rules! compiled_for {
        ($set:ident, $number:ident $(, $features:literal)?) => {
            mod $set {
                $(#[target_feature(enable = $features)])?
                pub(super) fn kept() -> [[f64; 2]; 2] {
                    let double = super::kept::<super::$number<f64>>(f64::EPSILON);
                    let single = super::kept::<super::$number<f32>>(f32::EPSILON.into());
                    [double, single]
                }
            }
        };
    }
    for_each_instruction_set!(compiled_for);

    /// Doubles round a product before they add to it, whatever the processor can: that is why a
    /// case gives the same bits on all of them.
    #[test]
    fn doubles_are_fused_nowhere() {
        macro_rules! entry {
            ($set:ident, $name:literal) => {
                ($name, $set::kept as unsafe fn() -> [[f64; 2]; 2])
            };
        }
        for (name, kept) in available_instruction_sets!(entry) {
            // SAFETY: the processor has the instructions for which the function is compiled.
            let [double, single] = unsafe { kept() };
            assert_eq!(double, [0.0, 0.0], "{name}");
            let fused = name != "baseline" || cfg!(target_arch = "aarch64");
            let square = if fused { f64::from(f32::EPSILON).powi(2) } else { 0.0 };
            assert_eq!(single, [-square, square], "{name}");
        }
    }
}
