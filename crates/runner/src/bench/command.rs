//! The command, run as by a user: memory and wall-clock time of a run, and a sweep on all cores.

use std::{
    fs,
    path::Path,
    process::{Child, Command, ExitStatus, Stdio},
    thread,
    time::{Duration, Instant},
};

use serde::Serialize;
use wholestring_case::Override;

use super::{session::Bench, well};
use crate::Error;

/// Starts the command with these arguments and changes of the case. Its only output is the reason
/// of a failure.
fn start_command(program: &Path, arguments: &[&str], changes: &[Override]) -> Result<Child, Error> {
    let mut command = Command::new(program);
    // Successive measurements write to the same folder.
    command.args(arguments).args(["--quiet", "--overwrite"]);
    for Override { key, value, .. } in changes {
        command.arg("--set").arg(format!("{key}={value}"));
    }
    command.stdout(Stdio::null());
    command.spawn().map_err(Error::failed)
}

/// Checks the exit status.
pub(super) fn check(status: ExitStatus) -> Result<(), Error> {
    match status.code() {
        Some(0) => Ok(()),
        Some(130) | None => Err(Error::Interrupted),
        // The command has printed the reason.
        Some(_) => Err(Error::Failed(format!("it ended with {status}"))),
    }
}

// Memory and wall-clock time of a whole run.

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
        let mut child = start_command(&self.program, &arguments, self.well.changes())?;
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
        check(status)?;
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

// A sweep on all cores, as started by a user: 15 depths by 4 friction factors.

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
                let mut child = start_command(&self.program, &arguments, &changes)?;
                check(child.wait().map_err(Error::failed)?)?;
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
