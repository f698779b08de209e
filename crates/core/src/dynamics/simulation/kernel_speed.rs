//! Access of benchmarks and tests to the inner loop: [`crate::internals`].

use super::{Either, Simulation, either};
use crate::{
    dynamics::kernel::step::{Abilities, Laws, Stepper},
    simd::counted::Flops,
};

/// The inner loop of a simulation by itself.
pub trait KernelAccess {
    /// Switches to one of [`instruction_sets`]; unchanged if there is none of that name.
    fn use_instructions(&mut self, name: &str);

    /// Takes `steps` steps of the inner loop alone, the top held where it is: a measure of speed.
    /// The simulation is no more than that afterwards.
    fn step_kernel(&mut self, steps: usize);

    /// Takes one step of the inner loop alone, as [`Self::step_kernel`] does, and counts its
    /// arithmetic: all of it, that of lanes which no element fills, too.
    fn count_kernel(&mut self) -> Flops;

    /// Multiplies and adds in the registers of the inner loop, so wide and so precise, `rounds`
    /// times and as fast as the processor can; how many floating-point operations that was.
    fn work_at_peak(&self, rounds: usize) -> u64;
}

/// Names of the instruction sets that this processor can run, the fastest first.
pub fn instruction_sets() -> Vec<&'static str> {
    let any = Abilities { laws: Laws { hertz: true, vector: true }, full: false };
    let all: Vec<Stepper> = Stepper::all(any);
    all.iter().map(|stepper| stepper.instructions).collect()
}

impl KernelAccess for Simulation {
    fn use_instructions(&mut self, name: &str) {
        either!(&mut self.0, run => run.use_instructions(name));
    }

    fn step_kernel(&mut self, steps: usize) {
        either!(&mut self.0, run => run.step_kernel(steps));
    }

    fn count_kernel(&mut self) -> Flops {
        either!(&mut self.0, run => run.count_kernel())
    }

    fn work_at_peak(&self, rounds: usize) -> u64 {
        either!(&self.0, run => run.work_at_peak(rounds))
    }
}
