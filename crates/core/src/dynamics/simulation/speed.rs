//! Measurement of the speed of a run.

use super::run::Run;
use crate::{
    dynamics::kernel::{
        chain::node,
        step::{StepInput, Stepper},
    },
    rock,
    simd::{counted::Flops, wide::Registers},
};

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
