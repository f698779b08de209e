//! `wholestring bench`: the machine's speed at this work.

mod clock;
mod kernel;
mod mechanisms;
mod memory;
mod process;
mod rock;
mod scratch;
mod sweep;
mod well;
mod whole_run;

use std::{fs, path::Path};

use indicatif::ProgressBar;
use serde::Serialize;

use wholestring_runner::CancellationToken;

use crate::{
    args::{BenchArgs, BenchPart},
    failure::Failure,
    interrupt, progress,
    terminal::say,
};
use clock::Spread;
use well::Well;

/// What was measured, for `--json`; a part that was not asked for is not there.
#[derive(Serialize)]
struct Numbers {
    version: &'static str,
    time: &'static str,
    #[serde(flatten)]
    well: well::About,
    #[serde(skip_serializing_if = "Option::is_none")]
    kernel: Option<kernel::Kernel>,
    #[serde(skip_serializing_if = "Option::is_none")]
    run: Option<Vec<whole_run::Row>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    mechanisms: Option<mechanisms::Mechanisms>,
    #[serde(skip_serializing_if = "Option::is_none")]
    rock: Option<rock::RockSpeed>,
    #[serde(skip_serializing_if = "Option::is_none")]
    memory: Option<memory::Memory>,
    #[serde(skip_serializing_if = "Option::is_none")]
    sweep: Option<sweep::Sweeps>,
}

/// How the measurements are taken.
struct Bench {
    well: Well,
    /// How often each is repeated.
    count: usize,
    cancellation: CancellationToken,
    bar: ProgressBar,
}

pub(crate) fn bench(args: &BenchArgs) -> Result<(), Failure> {
    let cancellation = interrupt::listen();
    let well = Well::new(&args.overrides)?;
    let bench = Bench {
        well,
        count: args.repeat.get(),
        cancellation,
        bar: progress::bar(0, false),
    };
    bench.bar.set_prefix("bench");
    let measured = bench.measure(args);
    bench.bar.finish_and_clear();
    measured
}

impl Bench {
    fn measure(&self, args: &BenchArgs) -> Result<(), Failure> {
        use BenchPart::{Kernel, Mechanisms, Memory, Rock, Run, Sweep};
        let asked = |part: BenchPart| {
            if args.parts.is_empty() {
                part != Sweep && (part != Memory || memory::IS_MEASURED)
            } else {
                args.parts.contains(&part)
            }
        };
        let about = self.well.about()?;
        self.print(&about.sentence(self.count))?;
        let mut numbers = Numbers {
            version: env!("CARGO_PKG_VERSION"),
            time: clock::KIND,
            well: about,
            kernel: None,
            run: None,
            mechanisms: None,
            rock: None,
            memory: None,
            sweep: None,
        };
        if asked(Kernel) {
            let kernel = kernel::measure(self)?;
            self.print(&kernel.text())?;
            numbers.kernel = Some(kernel);
        }
        if asked(Run) {
            let rows = whole_run::measure(self)?;
            self.print(&whole_run::text(&rows))?;
            numbers.run = Some(rows);
        }
        if asked(Memory) {
            let memory = memory::measure(self)?;
            self.print(&memory.text())?;
            numbers.memory = Some(memory);
        }
        if asked(Mechanisms) {
            let mechanisms = mechanisms::measure(self)?;
            self.print(&mechanisms.text())?;
            numbers.mechanisms = Some(mechanisms);
        }
        if asked(Rock) {
            let speed = rock::measure(self)?;
            self.print(&speed.text())?;
            numbers.rock = Some(speed);
        }
        if asked(Sweep) {
            let sweeps = sweep::measure(self)?;
            self.print(&sweeps.text())?;
            numbers.sweep = Some(sweeps);
        }
        match &args.json {
            Some(path) => write(path, &numbers),
            None => Ok(()),
        }
    }

    fn print(&self, text: &str) -> Result<(), Failure> {
        self.bar.suspend(|| say(&format!("{text}\n")))
    }

    /// Begins to measure `count` things.
    fn begin(&self, count: usize) {
        self.bar.set_position(0);
        self.bar.set_length(count as u64);
    }

    /// Shows what is measured next, unless the user asked to stop.
    fn next(&self, what: &str) -> Result<(), Failure> {
        self.bar.set_message(what.to_owned());
        self.bar.inc(1);
        if self.cancellation.is_cancelled() {
            return Err(Failure::Interrupted("interrupted".to_owned()));
        }
        Ok(())
    }

    /// Repeats a measurement.
    fn repeat(&self, mut measure: impl FnMut() -> Result<f64, Failure>) -> Result<Spread, Failure> {
        let mut found = Vec::new();
        for _ in 0..self.count {
            found.push(measure()?);
        }
        Ok(Spread::of(found))
    }
}

fn write(path: &Path, numbers: &Numbers) -> Result<(), Failure> {
    let text = serde_json::to_string_pretty(numbers).map_err(|error| failed(&error))?;
    fs::write(path, text + "\n").map_err(|error| {
        let place = path.display();
        Failure::Failed(format!("error: cannot write {place}: {error}"))
    })
}

fn failed(error: &dyn std::error::Error) -> Failure {
    Failure::Failed(format!("error: {error}"))
}
