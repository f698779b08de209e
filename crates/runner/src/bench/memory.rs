//! Memory and wall-clock time of a whole run.

use std::{
    fs, thread,
    time::{Duration, Instant},
};

use serde::Serialize;

use super::{process, session::Bench};
use crate::Error;

/// Whether this system reports the memory of another process.
pub const MEASURES_MEMORY: bool = cfg!(target_os = "linux");

/// Time between two checks of the process.
const POLL_INTERVAL: Duration = Duration::from_millis(5);

/// Memory and time of a run.
#[derive(Debug, Serialize)]
pub struct Memory {
    /// Simulated time, all operations together.
    pub simulated_s: f64,
    /// Wall-clock time.
    pub wall_time_s: f64,
    /// Largest resident memory, without the pages of the program file.
    pub peak_MB: f64,
}

impl Bench<'_> {
    /// Measures memory and wall-clock time of a whole run.
    ///
    /// # Errors
    /// As [`Self::kernel`]; the system reports no memory, or the program failed.
    pub fn memory(&self) -> Result<Memory, Error> {
        if !MEASURES_MEMORY {
            return Err(Error::BadInput("memory is measured on Linux only".to_owned()));
        }
        self.begin(1);
        self.next("memory of a run")?;
        let case = self.well.case(&[])?;
        let (file, folder) = (self.well.file(), self.well.folder());
        let arguments = ["run", &file.to_string_lossy(), "-o", &folder.to_string_lossy()];
        let start = Instant::now();
        let mut child = process::start(&self.program, &arguments, self.well.changes())?;
        let mut peak_MB: f64 = 0.0;
        let status = loop {
            if let Some(now_MB) = resident_MB(child.id()) {
                peak_MB = peak_MB.max(now_MB);
            }
            if let Some(status) = child.try_wait().map_err(Error::failed)? {
                break status;
            }
            thread::sleep(POLL_INTERVAL);
        };
        process::check(status)?;
        Ok(Memory {
            simulated_s: case.operations.len() as f64 * case.dynamics.longest_s(),
            wall_time_s: start.elapsed().as_secs_f64(),
            peak_MB,
        })
    }
}

/// Largest resident memory of a process so far, without the pages of its program file, which vary
/// with the debug information and which the system shares; `None` once it has ended.
fn resident_MB(process: u32) -> Option<f64> {
    let status = fs::read_to_string(format!("/proc/{process}/status")).ok()?;
    let kB = |name: &str| -> Option<f64> {
        let line = status.lines().find(|line| line.starts_with(name))?;
        line.split_whitespace().nth(1)?.parse().ok()
    };
    Some((kB("VmHWM:")? - kB("RssFile:")?) * 1024e-6)
}
