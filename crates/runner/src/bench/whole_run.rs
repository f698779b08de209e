//! All that a run does in its window: the inner loop, bit, hoist and top drive, the hole that goes
//! along, statistics.

use serde::Serialize;
use wholestring::internals::{KernelAccess, instruction_sets};

use super::{clock::Spread, session::Bench, well};
use crate::Error;

/// A whole run with one instruction set.
#[derive(Debug, Serialize)]
pub struct RunRow {
    /// `double` or `single`.
    pub precision: &'static str,
    /// The instruction set.
    pub instructions: &'static str,
    /// Time of a step, over the elements.
    pub ns_per_element_step: Spread,
    /// Simulated over processor time.
    pub real_time_factor: f64,
}

pub(super) fn measure(bench: &Bench) -> Result<Vec<RunRow>, Error> {
    let case = bench.well.case(&[])?;
    let precisions = well::precisions(&case);
    let sets = instruction_sets();
    bench.begin(precisions.len() * sets.len());
    let mut rows = Vec::new();
    for (precision, name) in precisions {
        let settled = well::initialise(&case, precision)?;
        for instructions in &sets {
            bench.next(&format!("whole run, {name} precision, {instructions}"))?;
            let mut simulation = settled.clone();
            simulation.use_instructions(instructions);
            let run_s = bench.repeat(|| bench.well.run_s(&case, &simulation))?;
            let element_steps_per_s = simulation.elements() as f64 / simulation.time_step_s();
            rows.push(RunRow {
                precision: name,
                instructions,
                ns_per_element_step: run_s.times(1e9 / element_steps_per_s),
                real_time_factor: 1.0 / run_s.median,
            });
        }
    }
    Ok(rows)
}
