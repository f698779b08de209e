//! `wholestring bench`: speed of this machine at the program's work.

use std::{
    env,
    num::NonZeroUsize,
    path::{Path, PathBuf},
};

use clap::{Args, ValueEnum};
use indicatif::ProgressBar;
use serde::Serialize;
use wholestring_case::Override;
use wholestring_results::write_file;
use wholestring_runner::{
    Error,
    bench::{
        Bench, Kernel, MEASURES_MEMORY, MeasuredWell, Mechanisms, Memory, RockSpeed, RunRow,
        Spread, Sweeps, TIME, Watcher,
    },
};

use crate::{
    failure::{Failure, failed},
    progress,
    screen::Table,
    terminal::{self, print_stdout},
};

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
        Bench::new(&args.overrides, args.repeat.get(), program, &screen, terminal::listen())?;
    screen.0.set_prefix("bench");
    let measured = measure(&bench, args, &screen);
    screen.0.finish_and_clear();
    measured
}

fn measure(bench: &Bench<'_>, args: &BenchArgs, screen: &Screen) -> Result<(), Failure> {
    let well = bench.well()?;
    screen.print(&sentence(&well, args.repeat.get()))?;
    let parts = Parts { bench, requested: &args.parts, screen };
    // In the order of the output.
    let numbers = Numbers {
        version: env!("CARGO_PKG_VERSION"),
        time: TIME,
        well,
        kernel: parts.show(BenchPart::Kernel, Bench::kernel, kernel)?,
        run: parts.show(BenchPart::Run, Bench::run, |rows| runs(rows))?,
        memory: parts.show(BenchPart::Memory, Bench::memory, memory)?,
        mechanisms: parts.show(BenchPart::Mechanisms, Bench::mechanisms, mechanisms)?,
        rock: parts.show(BenchPart::Rock, Bench::rock, rock)?,
        sweep: parts.show(BenchPart::Sweep, Bench::sweep, sweeps)?,
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

// Arguments of `wholestring bench`.

#[derive(Debug, Args)]
pub(crate) struct BenchArgs {
    /// Parts to measure [default: all but the sweep]
    #[arg(value_enum, value_name = "PART")]
    pub(crate) parts: Vec<BenchPart>,

    /// Set a key of the case that is measured, NP13-X1042. Repeatable
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub(crate) overrides: Vec<Override>,

    /// Measurements of which the median is shown
    #[arg(long, value_name = "N", default_value = "10")]
    pub(crate) repeat: NonZeroUsize,

    /// Write the numbers to this file too
    #[arg(long, value_name = "FILE")]
    pub(crate) json: Option<PathBuf>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum BenchPart {
    /// The inner loop with each instruction set, against the processor's peak
    Kernel,
    /// All that a run does, with each instruction set
    Run,
    /// Memory of a run, on Linux
    Memory,
    /// Cost of each mechanism when it is switched on
    Mechanisms,
    /// The solid rock under a bit, with each instruction set
    Rock,
    /// 60 cases for each friction law on all cores: minutes
    Sweep,
}

// Output of the measurements on the screen.

fn sentence(well: &MeasuredWell, count: usize) -> String {
    let MeasuredWell { case, bit_depth_m, elements, time_step_s, assembly_steps } = well;
    let step_ms = 1e3 * time_step_s;
    let assembly =
        assembly_steps.map_or_else(String::new, |steps| format!(", {steps} in it of the assembly"));
    format!(
        "{case}: bit at {bit_depth_m:.0} m, {elements} elements, steps of {step_ms:.3} \
         ms{assembly}; contact, friction and statistics on\n\
         {TIME}, median of {count}\n"
    )
}

fn kernel(kernel: &Kernel) -> String {
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
    for row in &kernel.rows {
        let [median, spread] = cells(row.ns_per_element_step, 1);
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
    let each = |count: u64| count as f64 / kernel.element_steps;
    let flops = kernel.flops;
    format!(
        "{}An element-step is {:.0} flop: {:.0} multiplications with addition (two each), \
         {:.0} multiplications, \
         {:.0} additions,\n{:.1} divisions and {:.1} roots (one each). The peak is the \
         best rate of multiplications and additions with the same registers.\n",
        table.text(),
        each(flops.total()),
        each(flops.multiply_additions),
        each(flops.multiplications),
        each(flops.additions),
        each(flops.divisions),
        each(flops.roots),
    )
}

fn runs(rows: &[RunRow]) -> String {
    let mut table = Table::new(
        "A whole run",
        2,
        &["precision", "instructions", "ns per element-step", "least to most", "× real time"],
    );
    for row in rows {
        let [median, spread] = cells(row.ns_per_element_step, 1);
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

fn memory(memory: &Memory) -> String {
    format!(
        "`wholestring run` of {:.0} s, results written: {:.1} s of wall-clock time, {:.1} MB of \
         memory at most\n",
        memory.simulated_s, memory.wall_time_s, memory.peak_MB
    )
}

fn mechanisms(mechanisms: &Mechanisms) -> String {
    let mut table = Table::new(
        "Cost of each mechanism in a whole run",
        1,
        &["switched on", "ns per element-step", "costs", "least to most"],
    );
    table.row(vec![
        "nothing".to_owned(),
        format!("{:.1}", mechanisms.ns_per_element_step),
        String::new(),
        String::new(),
    ]);
    for row in &mechanisms.rows {
        let percent = |ratio: f64| format!("{:+.0} %", 100.0 * (ratio - 1.0));
        let Spread { median, least, most } = row.time_ratio;
        table.row(vec![
            row.mechanism.to_owned(),
            format!("{:.1}", row.ns_per_element_step),
            percent(median),
            format!("{} to {}", percent(least), percent(most)),
        ]);
    }
    table.text()
}

fn rock(speed: &RockSpeed) -> String {
    let [x, y, z] = speed.cells;
    let title = format!(
        "Solid rock, {x} × {y} × {z} hexahedra of {:.0} mm under a bit of {:.0} mm",
        1e3 * speed.edge_m,
        1e3 * speed.bit_m
    );
    let mut table = Table::new(
        &title,
        2,
        &[
            "rock",
            "instructions",
            "ns per hexahedron-step",
            "least to most",
            "contact of it",
            "yielding",
            "nodes touching",
        ],
    );
    for row in &speed.rows {
        let [median, spread] = cells(row.ns_per_hexahedron_step, 1);
        table.row(vec![
            row.rock.to_owned(),
            row.instructions.to_owned(),
            median,
            spread,
            format!("{:.1}", row.contact_ns_per_hexahedron_step),
            format!("{:.0} %", 100.0 * row.yielding),
            row.touching_nodes.to_string(),
        ]);
    }
    table.text()
}

fn sweeps(sweeps: &Sweeps) -> String {
    let title =
        format!("A sweep of {} cases on {} cores, results written", sweeps.cases, sweeps.cores);
    let mut table = Table::new(
        &title,
        2,
        &["precision", "friction", "simulated, s", "wall-clock, s", "× real time"],
    );
    for row in &sweeps.rows {
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

/// Median, and the range from least to greatest.
fn cells(spread: Spread, decimals: usize) -> [String; 2] {
    let Spread { median, least, most } = spread;
    [format!("{median:.decimals$}"), format!("{least:.decimals$} to {most:.decimals$}")]
}
