//! One step of a block: the inner loop of the rock.
//!
//! Central differences: nodes drift with their velocities, element forces follow from positions and
//! velocities, nodes receive their impulses. The three follow each other layer by layer, so that a
//! layer is still in the cache. A row of elements along x writes the forces on its near and its far
//! corners side by side, in the order of the elements, and the rows of nodes add them: nothing is
//! gathered or scattered.
//!
//! A block is cut into slabs along z. Between two slabs a layer of nodes is shared: it drifts
//! before the slabs are processed and receives the impulses of both after them. So slabs may be
//! processed at the same time, and the sums are taken in one order.

mod fields;
mod nodes;
mod row;
mod slab;

use super::{constants::Constants, grid::Grid};
pub use fields::{Fields, RowBook};
use nodes::{drift, kick};
pub use slab::Slab;
use wholestring_numbers::simd::dispatch::{available_instruction_sets, for_each_instruction_set};

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
        f.debug_struct("Stepper").field("instructions", &self.instructions).finish()
    }
}

macro_rules! compiled_for {
    ($set:ident, $number:ident $(, $features:literal)?) => {
        mod $set {
            use super::*;
            type Number = wholestring_numbers::simd::dispatch::$number<f64>;

            $(#[target_feature(enable = $features)])?
            pub(super) unsafe fn begin(fields: &Fields, grid: &Grid, dt: f64, layer: usize) {
                // SAFETY: the caller's.
                unsafe { drift::<Number>(fields, grid, dt, layer) }
            }

            $(#[target_feature(enable = $features)])?
            pub(super) unsafe fn work(
                fields: &Fields,
                grid: &Grid,
                constants: &Constants,
                slab: &mut Slab,
            ) {
                // SAFETY: the caller's.
                unsafe { slab::work::<Number>(fields, grid, constants, slab) }
            }

            $(#[target_feature(enable = $features)])?
            pub(super) unsafe fn end(
                fields: &Fields,
                grid: &Grid,
                dt: f64,
                slab: &Slab,
                above: Option<&Slab>,
            ) {
                let (first, last) = (slab.first(), above.map(Slab::last));
                // SAFETY: the caller's.
                unsafe { kick::<Number>(fields, grid, dt, slab.from, first, last) }
            }
        }
    };
}
for_each_instruction_set!(compiled_for);

impl Default for Stepper {
    fn default() -> Self {
        Self::all()[0]
    }
}

impl Stepper {
    /// Every code that this processor can run, the fastest first; the baseline always is the last.
    pub fn all() -> Vec<Self> {
        macro_rules! choose {
            ($set:ident, $name:literal) => {
                Self { begin: $set::begin, work: $set::work, end: $set::end, instructions: $name }
            };
        }
        available_instruction_sets!(choose)
    }

    /// The nodes that a slab shares with the one above it drift.
    ///
    /// # Safety
    /// `fields` point to the state of a block of this grid, which nothing else uses.
    pub(crate) unsafe fn begin(&self, fields: &Fields, grid: &Grid, dt: f64, slab: &Slab) {
        // SAFETY: the caller's; `all` lists only code whose instructions the processor was found to
        // have.
        unsafe { (self.begin)(fields, grid, dt, slab.from) }
    }

    /// The elements of a slab answer, and its own nodes move.
    ///
    /// # Safety
    /// `fields` point to the state of a block of this grid, and nothing else uses this slab's part
    /// of it.
    pub(crate) unsafe fn work(
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
    pub(crate) unsafe fn end(
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
