//! The inner loop alone, the peak rate of the processor, and all work of a run in its window.

use serde::Serialize;
use wholestring::{
    dynamics::Simulation,
    internals::{Flops, KernelAccess, instruction_sets},
};

use super::{
    clock::{Clock, Spread},
    session::Bench,
    well::{self, TIMED_S},
};
use crate::Error;

/// Warm-up steps for caches and branch prediction.
const WARM_STEPS: usize = 20;

/// Rounds of the loop that measures the processor's peak; takes some milliseconds.
const PEAK_ROUNDS: usize = 1_000_000;

/// Measured speed of the inner loop.
#[derive(Debug, Default, Serialize)]
pub struct Kernel {
    /// Arithmetic of one step in double precision.
    pub flops: Flops,
    /// Elements times the substeps of each in one step.
    #[serde(skip)]
    pub element_steps: f64,
    /// A row for each precision and instruction set.
    pub rows: Vec<KernelRow>,
}

/// The inner loop with one instruction set.
#[derive(Debug, Serialize)]
pub struct KernelRow {
    /// `double` or `single`.
    pub precision: &'static str,
    /// The instruction set.
    pub instructions: &'static str,
    /// Time of a step per element and substep.
    pub ns_per_element_step: Spread,
    /// Rate of its arithmetic.
    pub gflop_per_s: f64,
    /// Peak rate of multiplications and additions in the same registers.
    pub peak_gflop_per_s: f64,
}

impl Bench<'_> {
    /// Measures the inner loop alone and the peak rate of the processor.
    ///
    /// # Errors
    /// As for all parts: the case has no simulation, or the user stopped the measurement.
    pub fn kernel(&self) -> Result<Kernel, Error> {
        let case = self.well.case(&[])?;
        let precisions = well::precisions(&case);
        let sets = instruction_sets();
        self.begin(precisions.len() * sets.len());
        let mut kernel = Kernel::default();
        for (precision, name) in precisions {
            let settled = well::initialise(&case, precision)?;
            let flops = settled.clone().count_kernel();
            let element_steps = settled.element_steps_per_s() * settled.time_step_s();
            if kernel.rows.is_empty() {
                (kernel.flops, kernel.element_steps) = (flops, element_steps);
            }
            for instructions in &sets {
                self.next(&format!("inner loop, {name} precision, {instructions}"))?;
                let mut simulation = settled.clone();
                simulation.use_instructions(instructions);
                let step_s = step_s(self, &simulation)?;
                let peak = peak(self, &simulation)?;
                kernel.rows.push(KernelRow {
                    precision: name,
                    instructions,
                    ns_per_element_step: step_s.times(1e9 / element_steps),
                    gflop_per_s: 1e-9 * flops.total() as f64 / step_s.median,
                    peak_gflop_per_s: 1e-9 * peak,
                });
            }
        }
        Ok(kernel)
    }
}

/// Time of one step, s.
fn step_s(bench: &Bench, simulation: &Simulation) -> Result<Spread, Error> {
    let steps = (TIMED_S / simulation.time_step_s()).ceil() as usize;
    bench.repeat(|| {
        let mut simulation = simulation.clone();
        simulation.step_kernel(WARM_STEPS);
        let clock = Clock::begin();
        simulation.step_kernel(steps);
        Ok(clock.elapsed_s() / steps as f64)
    })
}

/// Peak floating-point operations per second of the processor.
fn peak(bench: &Bench, simulation: &Simulation) -> Result<f64, Error> {
    let s_per_flop = bench.repeat(|| {
        let clock = Clock::begin();
        let flops = simulation.work_at_peak(PEAK_ROUNDS);
        Ok(clock.elapsed_s() / flops as f64)
    })?;
    Ok(1.0 / s_per_flop.least)
}

// All work of a run in its window: the inner loop, bit, hoist and top drive, the deepening hole,
// statistics.

/// A whole run with one instruction set.
#[derive(Debug, Serialize)]
pub struct RunRow {
    /// `double` or `single`.
    pub precision: &'static str,
    /// The instruction set.
    pub instructions: &'static str,
    /// Time of a step per element and substep.
    pub ns_per_element_step: Spread,
    /// Simulated time over processor time.
    pub real_time_factor: f64,
}

impl Bench<'_> {
    /// Measures all work of a run in its window.
    ///
    /// # Errors
    /// As [`Self::kernel`].
    pub fn run(&self) -> Result<Vec<RunRow>, Error> {
        let case = self.well.case(&[])?;
        let precisions = well::precisions(&case);
        let sets = instruction_sets();
        self.begin(precisions.len() * sets.len());
        let mut rows = Vec::new();
        for (precision, name) in precisions {
            let settled = well::initialise(&case, precision)?;
            for instructions in &sets {
                self.next(&format!("whole run, {name} precision, {instructions}"))?;
                let mut simulation = settled.clone();
                simulation.use_instructions(instructions);
                let run_s = self.repeat(|| self.well.run_s(&case, &simulation))?;
                rows.push(RunRow {
                    precision: name,
                    instructions,
                    ns_per_element_step: run_s.times(1e9 / simulation.element_steps_per_s()),
                    real_time_factor: 1.0 / run_s.median,
                });
            }
        }
        Ok(rows)
    }
}
