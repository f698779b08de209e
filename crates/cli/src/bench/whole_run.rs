//! All that a run does in its window: the inner loop, bit, hoist and top drive, the hole that goes
//! along, statistics.

use serde::Serialize;
use wholestring::internals::{KernelAccess, instruction_sets};

use super::{clock::Spread, session::Bench, well};
use crate::{failure::Failure, screen_table::Table};

#[derive(Serialize)]
pub(crate) struct Row {
    precision: &'static str,
    instructions: &'static str,
    ns_per_element_step: Spread,
    real_time_factor: f64,
}

pub(crate) fn measure(bench: &Bench) -> Result<Vec<Row>, Failure> {
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
            rows.push(Row {
                precision: name,
                instructions,
                ns_per_element_step: run_s.times(1e9 / element_steps_per_s),
                real_time_factor: 1.0 / run_s.median,
            });
        }
    }
    Ok(rows)
}

pub(crate) fn text(rows: &[Row]) -> String {
    let mut table = Table::new(
        "A whole run",
        2,
        &["precision", "instructions", "ns per element-step", "least to most", "× real time"],
    );
    for row in rows {
        let [median, spread] = row.ns_per_element_step.cells(1);
        table.row(vec![
            row.precision.to_owned(),
            row.instructions.to_owned(),
            median,
            spread,
            format!("{:.1}", row.real_time_factor),
        ]);
    }
    table.text()
}
