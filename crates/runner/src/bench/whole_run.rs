//! All work of a run in its window: the inner loop, bit, hoist and top drive, the deepening hole,
//! statistics.

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
