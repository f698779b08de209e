//! What benchmarks and tests of the kernel reach it by; no part of the public interface.

use super::{Either, Simulation, either};
use crate::{
    dynamics::kernel::step::{Abilities, Laws, Stepper},
    simd::counted::Flops,
};

#[doc(hidden)]
impl Simulation {
    /// Names of the instruction sets that this processor can run, the fastest first.
    pub fn instruction_sets() -> Vec<&'static str> {
        let any = Abilities { laws: Laws { hertz: true, vector: true }, full: false };
        let all: Vec<Stepper> = Stepper::all(any);
        all.iter().map(|stepper| stepper.instructions).collect()
    }

    /// Switches to one of [`Self::instruction_sets`]; with what it has if there is none of that
    /// name.
    pub fn use_instructions(&mut self, name: &str) {
        either!(&mut self.0, run => run.use_instructions(name));
    }

    /// Takes `steps` steps of the inner loop alone, the top held where it is: a measure of speed.
    /// The simulation is no more than that afterwards.
    pub fn step_kernel(&mut self, steps: usize) {
        either!(&mut self.0, run => run.step_kernel(steps));
    }

    /// Takes one step of the inner loop alone, as [`Self::step_kernel`] does, and counts its
    /// arithmetic: all of it, that of lanes which no element fills, too.
    pub fn count_kernel(&mut self) -> Flops {
        either!(&mut self.0, run => run.count_kernel())
    }

    /// Multiplies and adds in the registers of the inner loop, so wide and so precise, `rounds`
    /// times and as fast as the processor can; how many floating-point operations that was.
    pub fn work_at_peak(&self, rounds: usize) -> u64 {
        either!(&self.0, run => run.work_at_peak(rounds))
    }
}
