//! One step of a block: the inner loop of the rock.
//!
//! Central differences: nodes drift with their velocities, bricks answer to where they got and how fast, nodes are kicked.
//! The three follow each other layer by layer, so that a layer is still in the cache. A row of bricks along x writes what
//! its near and its far corners get side by side, in the order of the bricks, and the rows of nodes take it up: nothing
//! is gathered or scattered.
//!
//! A block is cut into slabs along z. Between two slabs a layer of nodes is shared: it drifts before the slabs are
//! worked on and is kicked after them, by what both have found. So slabs may be worked on at the same time, and the
//! sums are taken in one order.

mod fields;
mod nodes;
mod row;
mod slab;

use super::{constants::Constants, grid::Grid};
#[cfg(not(target_arch = "x86_64"))]
use crate::simd::wide::Pair;
#[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
use crate::simd::wide::Registers;
pub use fields::{Fields, RowBook};
use nodes::{drift, kick};
pub use slab::Slab;

/// Which code does the step: the processor's best instructions.
#[derive(Clone, Copy)]
pub struct Stepper {
    begin: unsafe fn(&Fields, &Grid, f64, usize),
    work: unsafe fn(&Fields, &Grid, &Constants, &mut Slab),
    end: unsafe fn(&Fields, &Grid, f64, &Slab, Option<&Slab>),
    /// Name of the instruction set in use.
    pub instructions: &'static str,
}

impl std::fmt::Debug for Stepper {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Stepper")
            .field("instructions", &self.instructions)
            .finish()
    }
}

macro_rules! compiled_for {
    ($begin:ident, $work:ident, $end:ident, $number:ty $(, $features:literal)?) => {
        $(#[target_feature(enable = $features)])?
        unsafe fn $begin(fields: &Fields, grid: &Grid, dt: f64, layer: usize) {
            // SAFETY: the caller's.
            unsafe { drift::<$number>(fields, grid, dt, layer) }
        }

        $(#[target_feature(enable = $features)])?
        unsafe fn $work(fields: &Fields, grid: &Grid, constants: &Constants, slab: &mut Slab) {
            // SAFETY: the caller's.
            unsafe { slab::work::<$number>(fields, grid, constants, slab) }
        }

        $(#[target_feature(enable = $features)])?
        unsafe fn $end(fields: &Fields, grid: &Grid, dt: f64, slab: &Slab, above: Option<&Slab>) {
            // SAFETY: the caller's.
            unsafe { kick::<$number>(fields, grid, dt, slab.from, slab.first(), above.map(Slab::last)) }
        }
    };
}

#[cfg(target_arch = "x86_64")]
compiled_for!(
    avx512_begin,
    avx512_work,
    avx512_end,
    <f64 as Registers>::Zmm,
    "avx512f,avx512dq,avx512vl,avx2,fma"
);
#[cfg(target_arch = "x86_64")]
compiled_for!(
    avx2_begin,
    avx2_work,
    avx2_end,
    <f64 as Registers>::Ymm,
    "avx2,fma"
);
#[cfg(target_arch = "x86_64")]
compiled_for!(
    baseline_begin,
    baseline_work,
    baseline_end,
    <f64 as Registers>::Xmm
);
#[cfg(target_arch = "aarch64")]
compiled_for!(
    baseline_begin,
    baseline_work,
    baseline_end,
    Pair<<f64 as Registers>::Fused>
);
#[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64")))]
compiled_for!(baseline_begin, baseline_work, baseline_end, Pair<f64>);

impl Default for Stepper {
    fn default() -> Self {
        Self::all()[0]
    }
}

impl Stepper {
    /// Every code that this processor can run, the fastest first; the baseline always is the last.
    pub fn all() -> Vec<Self> {
        macro_rules! choose {
            ($begin:ident, $work:ident, $end:ident, $name:literal) => {
                Self {
                    begin: $begin,
                    work: $work,
                    end: $end,
                    instructions: $name,
                }
            };
        }
        let mut all = Vec::new();
        #[cfg(target_arch = "x86_64")]
        {
            if crate::simd::wide::has_avx512() {
                all.push(choose!(avx512_begin, avx512_work, avx512_end, "AVX-512"));
            }
            if crate::simd::wide::has_avx2() {
                all.push(choose!(avx2_begin, avx2_work, avx2_end, "AVX2"));
            }
        }
        all.push(choose!(
            baseline_begin,
            baseline_work,
            baseline_end,
            "baseline"
        ));
        all
    }

    /// The nodes that a slab shares with the one above it drift.
    ///
    /// # Safety
    /// `fields` point to the state of a block of this grid, which nothing else uses.
    pub unsafe fn begin(&self, fields: &Fields, grid: &Grid, dt: f64, slab: &Slab) {
        // SAFETY: the caller's; `all` lists only code whose instructions the processor was found to have.
        unsafe { (self.begin)(fields, grid, dt, slab.from) }
    }

    /// The bricks of a slab answer, and its own nodes move.
    ///
    /// # Safety
    /// `fields` point to the state of a block of this grid, of which nothing else uses what is this slab's.
    pub unsafe fn work(
        &self,
        fields: &Fields,
        grid: &Grid,
        constants: &Constants,
        slab: &mut Slab,
    ) {
        // SAFETY: as for `begin`.
        unsafe { (self.work)(fields, grid, constants, slab) }
    }

    /// The nodes that a slab shares with the one above it are kicked.
    ///
    /// # Safety
    /// `fields` point to the state of a block of this grid, which nothing else uses.
    pub unsafe fn end(
        &self,
        fields: &Fields,
        grid: &Grid,
        dt: f64,
        slab: &Slab,
        above: Option<&Slab>,
    ) {
        // SAFETY: as for `begin`.
        unsafe { (self.end)(fields, grid, dt, slab, above) }
    }
}
