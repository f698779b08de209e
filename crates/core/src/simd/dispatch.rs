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

/// What a kernel computes with in code for AVX-512.
#[cfg(target_arch = "x86_64")]
pub type Avx512<R> = <R as Registers>::Zmm;

/// What it computes with in code for AVX2.
#[cfg(target_arch = "x86_64")]
pub type Avx2<R> = <R as Registers>::Ymm;

/// What it computes with in code for every processor of the target.
#[cfg(target_arch = "x86_64")]
pub type Baseline<R> = <R as Registers>::Xmm;
/// What it computes with in code for every processor of the target.
#[cfg(target_arch = "aarch64")]
pub type Baseline<R> = Pair<<R as Registers>::Fused>;
/// What it computes with in code for every processor of the target.
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
pub type Baseline<R> = <R as Registers>::V128;
/// What it computes with in code for every processor of the target.
#[cfg(not(any(
    target_arch = "x86_64",
    target_arch = "aarch64",
    all(target_arch = "wasm32", target_feature = "simd128")
)))]
pub type Baseline<R> = Pair<R>;

/// Expands a macro once for each instruction set of the target, with the name of a module, the type
/// of this file that its code computes with, whether a multiplication with addition is one
/// instruction of it, and the features that it is compiled with, if it needs any.
macro_rules! for_each_instruction_set {
    ($compile:ident) => {
        #[cfg(target_arch = "x86_64")]
        $compile!(avx512, Avx512, true, "avx512f,avx512dq,avx512vl,avx2,fma");
        #[cfg(target_arch = "x86_64")]
        $compile!(avx2, Avx2, true, "avx2,fma");
        $compile!(baseline, Baseline, cfg!(target_arch = "aarch64"));
    };
}

/// What a macro makes of the module and the name of each instruction set that this processor has,
/// the fastest first; the baseline always is the last.
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
macro_rules! with_fastest_instruction_set {
    ($function:ident($($argument:expr),* $(,)?)) => {{
        #[cfg(target_arch = "x86_64")]
        let done = if $crate::simd::wide::has_avx512() {
            // SAFETY: the processor has what the function is compiled for.
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

pub(crate) use {
    available_instruction_sets, for_each_instruction_set, with_fastest_instruction_set,
};
