//! Reads damaged inputs with every reader of wholestring, and reports the inputs on which a reader
//! failed.
//!
//! An input is generated from a number: a valid file of its kind with changed bytes, words, numbers
//! and lines. A reader may accept or refuse it; it must not panic, end the program, or use more
//! than a gigabyte of memory or two seconds. Inputs are read in separate processes, so that an
//! input that ends a process is reported and the next ones are read.

mod allocator;
mod mutation;
mod readers;
mod run;
mod tally;
mod worker;

use std::{
    collections::VecDeque,
    env,
    path::{Path, PathBuf},
    process::ExitCode,
    sync::Mutex,
    thread,
    time::Duration,
};

use run::Outcome;
use worker::Inputs;

#[global_allocator]
static MEMORY: allocator::Counting = allocator::Counting;

const USAGE: &str = "\
usage: wholestring-fuzz [SECONDS | --inputs N] [--seed S] [READER...]
       wholestring-fuzz --one READER INPUT [--seed S]    read one input, and write it to \
       target/fuzz";

/// Practically unlimited time; workers receive it in milliseconds.
const ENDLESS: Duration = Duration::from_secs(365 * 86_400);

/// Total number of inputs of all readers, or the total time.
enum Amount {
    Time(Duration),
    Inputs(u64),
}

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let done = match arguments[..] {
        ["--worker", reader, ref rest @ ..] => work(reader, rest),
        ["--one", reader, input, ref rest @ ..] => one(reader, input, rest),
        _ => watch(&arguments),
    };
    done.unwrap_or_else(|reason| {
        eprintln!("{reason}\n{USAGE}");
        ExitCode::from(2)
    })
}

fn number(text: &str) -> Result<u64, String> {
    text.parse().map_err(|_| format!("`{text}` is not a whole number"))
}

fn work(reader: &str, rest: &[&str]) -> Result<ExitCode, String> {
    let [seed, from, count, milliseconds, counted] = rest else {
        return Err("a worker is started by the watcher".into());
    };
    let inputs = Inputs {
        seed: number(seed)?,
        from: number(from)?,
        count: number(count)?,
        time: Duration::from_millis(number(milliseconds)?),
    };
    let mut reader = readers::of(reader)?;
    worker::work(&mut reader, inputs, Path::new(counted)).map_err(|error| error.to_string())?;
    Ok(ExitCode::SUCCESS)
}

fn one(reader: &str, input: &str, rest: &[&str]) -> Result<ExitCode, String> {
    let seed = match rest {
        [] => 1,
        ["--seed", seed] => number(seed)?,
        _ => return Err("one input is a reader and a number".into()),
    };
    let mut reader = readers::of(reader)?;
    let folder = PathBuf::from("target/fuzz");
    worker::one(&mut reader, seed, number(input)?, &folder).map_err(|error| error.to_string())?;
    Ok(ExitCode::SUCCESS)
}

fn watch(arguments: &[&str]) -> Result<ExitCode, String> {
    let (mut amount, mut seed, mut chosen) = (Amount::Time(Duration::from_secs(20)), 1, Vec::new());
    let mut rest = arguments.iter();
    while let Some(argument) = rest.next() {
        let mut value = || number(rest.next().copied().unwrap_or_default());
        match *argument {
            "--inputs" => amount = Amount::Inputs(value()?),
            "--seed" => seed = value()?,
            name => match readers::names().into_iter().find(|known| *known == name) {
                Some(known) => chosen.push(known),
                None => match name.parse() {
                    Ok(seconds) => amount = Amount::Time(Duration::from_secs(seconds)),
                    Err(_) => {
                        let known = readers::names().join(", ");
                        return Err(format!("`{name}` is not a reader; the readers are {known}"));
                    }
                },
            },
        }
    }
    if chosen.is_empty() {
        chosen = readers::names();
    }
    let outcomes = read_all(&chosen, &amount, seed)?;
    Ok(report(&outcomes, seed))
}

/// Runs every reader, as many at a time as there are processors.
fn read_all(
    chosen: &[&'static str],
    amount: &Amount,
    seed: u64,
) -> Result<Vec<(&'static str, Outcome)>, String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let side_by_side = thread::available_parallelism().map_or(1, usize::from).min(chosen.len());
    let inputs = match amount {
        // The readers run in turn: each has its share of the time of all processors.
        Amount::Time(all) => Inputs {
            seed,
            from: 0,
            count: u64::MAX,
            time: all.mul_f64(side_by_side as f64 / chosen.len() as f64),
        },
        Amount::Inputs(all) => {
            Inputs { seed, from: 0, count: all.div_ceil(chosen.len() as u64), time: ENDLESS }
        }
    };
    let waiting = Mutex::new(chosen.iter().copied().collect::<VecDeque<_>>());
    let next = || waiting.lock().map(|mut waiting| waiting.pop_front()).ok().flatten();
    let outcomes = Mutex::new(Vec::new());
    let work = || {
        while let Some(reader) = next() {
            let outcome = run::run(reader, inputs, folder.path());
            if let Ok(mut outcomes) = outcomes.lock() {
                outcomes.push((reader, outcome));
            }
        }
    };
    thread::scope(|scope| {
        // If the system refuses a thread, the existing ones do all of the work.
        for _ in 1..side_by_side {
            if thread::Builder::new().spawn_scoped(scope, work).is_err() {
                break;
            }
        }
        work();
    });
    let mut outcomes = outcomes.into_inner().map_err(|error| error.to_string())?;
    outcomes.sort_by_key(|(reader, _)| chosen.iter().position(|name| name == reader));
    outcomes
        .into_iter()
        .map(|(reader, outcome)| {
            Ok((reader, outcome.map_err(|error| format!("{reader}: {error}"))?))
        })
        .collect()
}

/// Prints a line for each reader, and each fault with the command that reproduces it.
fn report(outcomes: &[(&'static str, Outcome)], seed: u64) -> ExitCode {
    println!(
        "{:<14}{:>10}{:>10}{:>10}{:>8}  {:<22}peak memory, MB",
        "reader", "inputs", "accepted", "refused", "faults", "slowest, s"
    );
    let mut sum = 0;
    for (reader, outcome) in outcomes {
        let tally = &outcome.tally;
        sum += tally.inputs();
        let slowest = format!("{:.3} (#{})", tally.slowest.as_secs_f64(), tally.slowest_input);
        println!(
            "{reader:<14}{:>10}{:>10}{:>10}{:>8}  {slowest:<22}{} (#{})",
            tally.inputs(),
            tally.accepted,
            tally.refused,
            outcome.faults.len(),
            tally.peak_bytes.div_ceil(1 << 20),
            tally.peak_input
        );
    }
    let faults: Vec<_> = outcomes.iter().flat_map(|(_, outcome)| &outcome.faults).collect();
    println!("{sum} inputs, {} faults, seed {seed}", faults.len());
    for fault in &faults {
        println!("{} #{} {}", fault.reader, fault.input, fault.what);
        println!(
            "    again: cargo run -p wholestring-fuzz -- --one {} {} --seed {seed}",
            fault.reader, fault.input
        );
    }
    if faults.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A worker parses the parent's arguments: an unlimited time exceeded its number format.
    #[test]
    fn a_number_of_inputs_has_a_time_that_workers_read() {
        let milliseconds = ENDLESS.as_millis().to_string();
        assert_eq!(number(&milliseconds).map(Duration::from_millis), Ok(ENDLESS));
    }
}
