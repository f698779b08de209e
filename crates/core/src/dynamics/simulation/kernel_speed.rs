//! Measurement of the speed of a run, and access of benchmarks and tests to the inner loop:
//! [`crate::internals`].

use super::{Either, Simulation, either, run::Run};
use crate::{
    dynamics::kernel::{
        chain::node,
        step::{Abilities, Laws, StepInput, Stepper},
    },
    rock,
    simd::{counted::Flops, wide::Registers},
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

// Measurement of the speed of a run.

impl<R: Registers> Run<R> {
    /// Switches to one of the instruction sets; unchanged if there is none of that name.
    pub fn use_instructions(&mut self, name: &str) {
        let mut all = Stepper::all(self.abilities).into_iter();
        if let Some(stepper) = all.find(|stepper| stepper.instructions == name) {
            self.stepper = stepper;
        }
        let mut all = rock::Stepper::all().into_iter();
        if let Some(stepper) = all.find(|stepper| stepper.instructions == name) {
            self.executor.stepper = stepper;
        }
    }

    /// Takes `steps` steps of the inner loop alone, the top held where it is. The run is no more
    /// than that afterwards.
    pub fn step_kernel(&mut self, steps: usize) {
        let input = self.hold_top();
        for _ in 0..steps {
            self.stepper.step(&mut self.chain, &input);
        }
    }

    /// Takes one such step and counts its arithmetic.
    pub fn count_kernel(&mut self) -> Flops {
        let input = self.hold_top();
        Stepper::count(self.abilities, &mut self.chain, &input)
    }

    /// Does as much arithmetic in the registers of the inner loop as the processor can, `rounds`
    /// times; how many floating-point operations that was.
    pub fn work_at_peak(&self, rounds: usize) -> u64 {
        self.stepper.work(rounds)
    }

    fn hold_top(&mut self) -> StepInput {
        node!(self.chain, 0, inv_mass_axial = 0.0);
        self.step_input()
    }
}
