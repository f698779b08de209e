//! The inner loop alone, and what the processor could do at best.

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
use crate::{failure::Failure, screen_table::Table};

/// Steps after which caches and the prediction of branches know the loop.
const WARM_STEPS: usize = 20;

/// Rounds of the loop that finds the processor's peak: some milliseconds.
const PEAK_ROUNDS: usize = 1_000_000;

/// What was found.
#[derive(Default, Serialize)]
pub(crate) struct Kernel {
    /// Arithmetic of one step in double precision.
    flops: Flops,
    #[serde(skip)]
    elements: usize,
    rows: Vec<Row>,
}

#[derive(Serialize)]
struct Row {
    precision: &'static str,
    instructions: &'static str,
    ns_per_element_step: Spread,
    gflop_per_s: f64,
    peak_gflop_per_s: f64,
}

pub(crate) fn measure(bench: &Bench) -> Result<Kernel, Failure> {
    let case = bench.well.case(&[])?;
    let precisions = well::precisions(&case);
    let sets = instruction_sets();
    bench.begin(precisions.len() * sets.len());
    let mut kernel = Kernel::default();
    for (precision, name) in precisions {
        let settled = well::initialise(&case, precision)?;
        let (flops, elements) = (settled.clone().count_kernel(), settled.elements());
        if kernel.rows.is_empty() {
            (kernel.flops, kernel.elements) = (flops, elements);
        }
        for instructions in &sets {
            bench.next(&format!("inner loop, {name} precision, {instructions}"))?;
            let mut simulation = settled.clone();
            simulation.use_instructions(instructions);
            let step_s = step_s(bench, &simulation)?;
            let peak = peak(bench, &simulation)?;
            kernel.rows.push(Row {
                precision: name,
                instructions,
                ns_per_element_step: step_s.times(1e9 / elements as f64),
                gflop_per_s: 1e-9 * flops.total() as f64 / step_s.median,
                peak_gflop_per_s: 1e-9 * peak,
            });
        }
    }
    Ok(kernel)
}

/// Time of one step, s.
fn step_s(bench: &Bench, simulation: &Simulation) -> Result<Spread, Failure> {
    let steps = (TIMED_S / simulation.time_step_s()).ceil() as usize;
    bench.repeat(|| {
        let mut simulation = simulation.clone();
        simulation.step_kernel(WARM_STEPS);
        let clock = Clock::begin();
        simulation.step_kernel(steps);
        Ok(clock.elapsed_s() / steps as f64)
    })
}

/// Floating-point operations per second that the processor does at best.
fn peak(bench: &Bench, simulation: &Simulation) -> Result<f64, Failure> {
    let s_per_flop = bench.repeat(|| {
        let clock = Clock::begin();
        let flops = simulation.work_at_peak(PEAK_ROUNDS);
        Ok(clock.elapsed_s() / flops as f64)
    })?;
    Ok(1.0 / s_per_flop.least)
}

impl Kernel {
    pub(crate) fn text(&self) -> String {
        let mut table = Table::new(
            "The inner loop",
            2,
            &[
                "precision",
                "instructions",
                "ns per element-step",
                "least to most",
                "Gflop/s",
                "peak",
                "of it",
            ],
        );
        for row in &self.rows {
            let [median, spread] = row.ns_per_element_step.cells(1);
            let share = row.gflop_per_s / row.peak_gflop_per_s;
            table.row(vec![
                row.precision.to_owned(),
                row.instructions.to_owned(),
                median,
                spread,
                format!("{:.1}", row.gflop_per_s),
                format!("{:.1}", row.peak_gflop_per_s),
                format!("{:.0} %", 100.0 * share),
            ]);
        }
        let each = |count: u64| count as f64 / self.elements as f64;
        let flops = self.flops;
        format!(
            "{}An element-step is {:.0} flop: {:.0} multiplications with addition (two each), \
             {:.0} multiplications, \
             {:.0} additions,\n{:.1} divisions and {:.1} roots (one each). The peak is what the \
             same registers \
             multiply and add at best.\n",
            table.text(),
            each(flops.total()),
            each(flops.multiply_additions),
            each(flops.multiplications),
            each(flops.additions),
            each(flops.divisions),
            each(flops.roots),
        )
    }
}
