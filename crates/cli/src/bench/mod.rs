//! `wholestring bench`: the machine's speed at this work.

mod clock;
mod kernel;
mod mechanisms;
mod memory;
mod process;
mod rock;
mod scratch;
mod session;
mod sweep;
mod well;
mod whole_run;

use std::{fs, path::Path};

use serde::Serialize;

use crate::{
    args::{BenchArgs, BenchPart},
    failure::{Failure, failed},
    interrupt, progress,
};
use session::Bench;
use well::Well;

/// What was measured, for `--json`; a part that was not requested is not there.
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

pub(crate) fn bench(args: &BenchArgs) -> Result<(), Failure> {
    let cancellation = interrupt::listen();
    let well = Well::new(&args.overrides)?;
    let bench =
        Bench { well, count: args.repeat.get(), cancellation, bar: progress::bar(0, false) };
    bench.bar.set_prefix("bench");
    let measured = measure(&bench, args);
    bench.bar.finish_and_clear();
    measured
}

fn measure(bench: &Bench, args: &BenchArgs) -> Result<(), Failure> {
    use BenchPart::{Kernel, Mechanisms, Memory, Rock, Run, Sweep};
    let requested = |part: BenchPart| {
        if args.parts.is_empty() {
            part != Sweep && (part != Memory || memory::IS_MEASURED)
        } else {
            args.parts.contains(&part)
        }
    };
    let about = bench.well.about()?;
    bench.print(&about.sentence(bench.count))?;
    // In the order in which they are shown.
    let numbers = Numbers {
        version: env!("CARGO_PKG_VERSION"),
        time: clock::KIND,
        well: about,
        kernel: part(bench, requested(Kernel), kernel::measure, kernel::Kernel::text)?,
        run: part(bench, requested(Run), whole_run::measure, |rows| whole_run::text(rows))?,
        memory: part(bench, requested(Memory), memory::measure, memory::Memory::text)?,
        mechanisms: part(
            bench,
            requested(Mechanisms),
            mechanisms::measure,
            mechanisms::Mechanisms::text,
        )?,
        rock: part(bench, requested(Rock), rock::measure, rock::RockSpeed::text)?,
        sweep: part(bench, requested(Sweep), sweep::measure, sweep::Sweeps::text)?,
    };
    match &args.json {
        Some(path) => write(path, &numbers),
        None => Ok(()),
    }
}

/// Measures a part that is requested, and shows it.
fn part<T>(
    bench: &Bench,
    requested: bool,
    measure: fn(&Bench) -> Result<T, Failure>,
    text: fn(&T) -> String,
) -> Result<Option<T>, Failure> {
    if !requested {
        return Ok(None);
    }
    let measured = measure(bench)?;
    bench.print(&text(&measured))?;
    Ok(Some(measured))
}

fn write(path: &Path, numbers: &Numbers) -> Result<(), Failure> {
    let text = serde_json::to_string_pretty(numbers).map_err(|error| failed(&error))?;
    fs::write(path, text + "\n").map_err(|error| {
        let place = path.display();
        Failure::Failed(format!("error: cannot write {place}: {error}"))
    })
}
