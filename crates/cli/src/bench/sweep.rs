//! A sweep as a user runs it, on all cores: 15 depths by 4 friction factors.

use std::{thread, time::Instant};

use serde::Serialize;

use super::{process, session::Bench, well};
use crate::{
    failure::{Failure, failed},
    screen_table::Table,
};

const DEPTHS: &str = "bit_depth=300m..4305m/300m";
const FRICTIONS: &str = "friction=0.1,0.2,0.3,0.4";
const CASES: usize = 15 * 4;

#[derive(Serialize)]
pub(crate) struct Sweeps {
    cores: usize,
    cases: usize,
    rows: Vec<Row>,
}

#[derive(Serialize)]
struct Row {
    precision: &'static str,
    friction_law: &'static str,
    wall_time_s: f64,
    simulated_s: f64,
}

pub(crate) fn measure(bench: &Bench) -> Result<Sweeps, Failure> {
    const LAWS: [&str; 2] = ["vector", "independent"];
    let case = bench.well.case(&[])?;
    let precisions = well::precisions(&case);
    bench.begin(precisions.len() * LAWS.len());
    let (file, folder) = (bench.well.file(), bench.well.folder());
    let (file, folder) = (file.to_string_lossy(), folder.to_string_lossy());
    let mut rows = Vec::new();
    for (_, precision) in precisions {
        for law in LAWS {
            bench
                .next(&format!("sweep of {CASES} cases, {precision} precision, {law} friction"))?;
            let mut changes = bench.well.changes().to_vec();
            for key in
                [format!("dynamics.precision={precision}"), format!("dynamics.friction_law={law}")]
            {
                changes.push(key.parse().map_err(|error| failed(&error))?);
            }
            let arguments = ["sweep", &file, "--vary", DEPTHS, "--vary", FRICTIONS, "-o", &folder];
            let start = Instant::now();
            let mut child = process::start(&arguments, &changes)?;
            process::check(child.wait().map_err(|error| failed(&error))?)?;
            rows.push(Row {
                precision,
                friction_law: law,
                wall_time_s: start.elapsed().as_secs_f64(),
                simulated_s: CASES as f64 * case.dynamics.longest_s(),
            });
        }
    }
    Ok(Sweeps { cores: thread::available_parallelism().map_or(1, usize::from), cases: CASES, rows })
}

impl Sweeps {
    pub(crate) fn text(&self) -> String {
        let title =
            format!("A sweep of {} cases on {} cores, results written", self.cases, self.cores);
        let mut table = Table::new(
            &title,
            2,
            &["precision", "friction", "simulated, s", "on the clock, s", "× real time"],
        );
        for row in &self.rows {
            table.row(vec![
                row.precision.to_owned(),
                row.friction_law.to_owned(),
                format!("{:.0}", row.simulated_s),
                format!("{:.1}", row.wall_time_s),
                format!("{:.1}", row.simulated_s / row.wall_time_s),
            ]);
        }
        table.text()
    }
}
