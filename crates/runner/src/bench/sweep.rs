//! A sweep on all cores, as started by a user: 15 depths by 4 friction factors.

use std::{thread, time::Instant};

use serde::Serialize;

use super::{process, session::Bench, well};
use crate::Error;

const DEPTHS: &str = "bit_depth=300m..4305m/300m";
const FRICTIONS: &str = "friction=0.1,0.2,0.3,0.4";
const CASES: usize = 15 * 4;

/// Measured speed of sweeps.
#[derive(Debug, Serialize)]
pub struct Sweeps {
    /// Cores of the machine.
    pub cores: usize,
    /// Cases of a sweep.
    pub cases: usize,
    /// A row for each sweep.
    pub rows: Vec<SweepRow>,
}

/// One sweep.
#[derive(Debug, Serialize)]
pub struct SweepRow {
    /// `double` or `single`.
    pub precision: &'static str,
    /// Friction law.
    pub friction_law: &'static str,
    /// Wall-clock time.
    pub wall_time_s: f64,
    /// Simulated time, all cases together.
    pub simulated_s: f64,
}

impl Bench<'_> {
    /// Measures sweeps on all cores.
    ///
    /// # Errors
    /// As [`Self::kernel`]; the program failed.
    pub fn sweep(&self) -> Result<Sweeps, Error> {
        const LAWS: [&str; 2] = ["vector", "independent"];
        let case = self.well.case(&[])?;
        let precisions = well::precisions(&case);
        self.begin(precisions.len() * LAWS.len());
        let (file, folder) = (self.well.file(), self.well.folder());
        let (file, folder) = (file.to_string_lossy(), folder.to_string_lossy());
        let mut rows = Vec::new();
        for (_, precision) in precisions {
            for law in LAWS {
                self.next(&format!(
                    "sweep of {CASES} cases, {precision} precision, {law} friction"
                ))?;
                let mut changes = self.well.changes().to_vec();
                for key in [
                    format!("dynamics.precision={precision}"),
                    format!("dynamics.friction_law={law}"),
                ] {
                    changes.push(key.parse().map_err(Error::failed)?);
                }
                let arguments =
                    ["sweep", &file, "--vary", DEPTHS, "--vary", FRICTIONS, "-o", &folder];
                let start = Instant::now();
                let mut child = process::start(&self.program, &arguments, &changes)?;
                process::check(child.wait().map_err(Error::failed)?)?;
                rows.push(SweepRow {
                    precision,
                    friction_law: law,
                    wall_time_s: start.elapsed().as_secs_f64(),
                    simulated_s: CASES as f64 * case.dynamics.longest_s(),
                });
            }
        }
        Ok(Sweeps {
            cores: thread::available_parallelism().map_or(1, usize::from),
            cases: CASES,
            rows,
        })
    }
}
