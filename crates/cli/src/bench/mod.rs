//! `wholestring bench`: speed of this machine at the program's work.

mod args;
mod screen;

use std::{env, path::Path};

use indicatif::ProgressBar;
use serde::Serialize;
use wholestring_results::write_file;
use wholestring_runner::{
    Error,
    bench::{
        Bench, Kernel, MEASURES_MEMORY, MeasuredWell, Mechanisms, Memory, RockSpeed, RunRow,
        Sweeps, TIME, Watcher,
    },
};

use crate::{
    failure::{Failure, failed},
    interrupt, progress,
    terminal::print_stdout,
};

pub(crate) use args::BenchArgs;
use args::BenchPart;

/// The measurements, for `--json`; parts that were not requested are missing.
#[derive(Serialize)]
struct Numbers {
    version: &'static str,
    time: &'static str,
    #[serde(flatten)]
    well: MeasuredWell,
    #[serde(skip_serializing_if = "Option::is_none")]
    kernel: Option<Kernel>,
    #[serde(skip_serializing_if = "Option::is_none")]
    run: Option<Vec<RunRow>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    mechanisms: Option<Mechanisms>,
    #[serde(skip_serializing_if = "Option::is_none")]
    rock: Option<RockSpeed>,
    #[serde(skip_serializing_if = "Option::is_none")]
    memory: Option<Memory>,
    #[serde(skip_serializing_if = "Option::is_none")]
    sweep: Option<Sweeps>,
}

/// The bar that names the part being measured.
struct Screen(ProgressBar);

impl Watcher for Screen {
    fn begun(&self, count: usize) {
        self.0.set_position(0);
        self.0.set_length(count as u64);
    }

    fn next(&self, what: &str) {
        self.0.set_message(what.to_owned());
        self.0.inc(1);
    }
}

impl Screen {
    fn print(&self, text: &str) -> Result<(), Failure> {
        self.0.suspend(|| print_stdout(&format!("{text}\n")))
    }
}

pub(crate) fn bench(args: &BenchArgs) -> Result<(), Failure> {
    let screen = Screen(progress::bar(0, false));
    let program = env::current_exe().map_err(|error| failed(&error))?;
    let bench =
        Bench::new(&args.overrides, args.repeat.get(), program, &screen, interrupt::listen())?;
    screen.0.set_prefix("bench");
    let measured = measure(&bench, args, &screen);
    screen.0.finish_and_clear();
    measured
}

fn measure(bench: &Bench<'_>, args: &BenchArgs, screen: &Screen) -> Result<(), Failure> {
    let well = bench.well()?;
    screen.print(&screen::sentence(&well, args.repeat.get()))?;
    let parts = Parts { bench, requested: &args.parts, screen };
    // In the order of the output.
    let numbers = Numbers {
        version: env!("CARGO_PKG_VERSION"),
        time: TIME,
        well,
        kernel: parts.show(BenchPart::Kernel, Bench::kernel, screen::kernel)?,
        run: parts.show(BenchPart::Run, Bench::run, |rows| screen::runs(rows))?,
        memory: parts.show(BenchPart::Memory, Bench::memory, screen::memory)?,
        mechanisms: parts.show(BenchPart::Mechanisms, Bench::mechanisms, screen::mechanisms)?,
        rock: parts.show(BenchPart::Rock, Bench::rock, screen::rock)?,
        sweep: parts.show(BenchPart::Sweep, Bench::sweep, screen::sweeps)?,
    };
    match &args.json {
        Some(path) => write(path, &numbers),
        None => Ok(()),
    }
}

/// The parts to measure, and the screen.
struct Parts<'a> {
    bench: &'a Bench<'a>,
    requested: &'a [BenchPart],
    screen: &'a Screen,
}

impl<'a> Parts<'a> {
    /// Measures a requested part and prints it.
    fn show<T>(
        &self,
        part: BenchPart,
        measure: fn(&Bench<'a>) -> Result<T, Error>,
        text: fn(&T) -> String,
    ) -> Result<Option<T>, Failure> {
        let requested = if self.requested.is_empty() {
            part != BenchPart::Sweep && (part != BenchPart::Memory || MEASURES_MEMORY)
        } else {
            self.requested.contains(&part)
        };
        if !requested {
            return Ok(None);
        }
        let measured = measure(self.bench).map_err(|error| match error {
            Error::Interrupted => Failure::Interrupted("interrupted".to_owned()),
            _ => error.into(),
        })?;
        self.screen.print(&text(&measured))?;
        Ok(Some(measured))
    }
}

fn write(path: &Path, numbers: &Numbers) -> Result<(), Failure> {
    let text = serde_json::to_string_pretty(numbers).map_err(|error| failed(&error))?;
    Ok(write_file(path, (text + "\n").as_bytes())?)
}
