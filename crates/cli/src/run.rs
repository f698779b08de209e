//! `wholestring run`: solves a case, prints one table and writes the results.

use std::{
    path::{Path, PathBuf},
    time::Instant,
};

use wholestring::{
    dynamics::Simulation,
    operation::Operation,
    statics::soft::{self, SoftSettings},
};
use wholestring_case::{Case, ModelKind};
use wholestring_results::{ResultsFolder, Status};

use crate::{
    args::RunArgs,
    comparison,
    failure::Failure,
    interrupt::Interrupt,
    load,
    progress::Progress,
    record::{self, Record},
    say,
};

pub(crate) fn run(args: &RunArgs) -> Result<(), Failure> {
    let case = load(&args.case, args.quiet)?;
    let units = args.units.unwrap_or(case.units);
    let output = args
        .output
        .clone()
        .unwrap_or_else(|| default_output(&case.name));
    // Before anything is solved, so that a long run does not end on a folder it may not write to.
    let folder = ResultsFolder::create(output)?;
    let interrupt = Interrupt::listen();
    let mut record = Record::new(&case, units);
    let solved = solve(&case, args, &interrupt, &mut record, &folder);
    if !args.quiet && !record.summary.operations.is_empty() {
        let width = terminal_size::terminal_size().map(|(width, _)| usize::from(width.0));
        let title = format!("{}: {}", case.name, record::subtitle(&case, units));
        let table = comparison::table(&record.summary, units, width);
        let notes = comparison::notes(&record.summary);
        let place = folder.path().display();
        say(&format!(
            "{title}

{table}
{notes}Results in {place}
"
        ))?;
    }
    solved
}

/// Solves operation after operation, each with every model, and writes after each, so that whatever
/// comes between keeps what was solved.
fn solve(
    case: &Case,
    args: &RunArgs,
    interrupt: &Interrupt,
    record: &mut Record,
    folder: &ResultsFolder,
) -> Result<(), Failure> {
    for operation in &case.operations {
        for model in &case.models {
            if interrupt.asked() {
                return Err(interrupted(folder.path()));
            }
            let stopped = match model {
                ModelKind::Soft => solve_soft(case, operation, record)?,
                ModelKind::Dynamic => solve_dynamic(case, operation, args, interrupt, record)?,
            };
            record.write(folder, args.csv)?;
            match stopped {
                Status::Complete => {}
                Status::Interrupted => return Err(interrupted(folder.path())),
                Status::Failed(reason) => {
                    return Err(Failure::Failed(format!(
                        "error: {}: {reason}\nwhat was computed until then is in {}",
                        operation.kind.name(),
                        folder.path().display()
                    )));
                }
            }
        }
    }
    Ok(())
}

fn solve_soft(case: &Case, operation: &Operation, record: &mut Record) -> Result<Status, Failure> {
    let profile = soft::solve(&case.model, operation, &SoftSettings::default())
        .map_err(|error| unsolvable("soft string", operation, &error))?;
    record.add_soft(operation, &profile);
    Ok(Status::Complete)
}

/// Simulated time between two looks at Ctrl-C and two movements of the progress bar, s: a fraction of
/// a second even where a run is slower than real time.
const LOOK_INTERVAL_S: f64 = 0.2;

fn solve_dynamic(
    case: &Case,
    operation: &Operation,
    args: &RunArgs,
    interrupt: &Interrupt,
    record: &mut Record,
) -> Result<Status, Failure> {
    let start = Instant::now();
    let mut simulation = Simulation::new(&case.model, operation, &case.dynamics)
        .map_err(|error| unsolvable("dynamic model", operation, &error))?;
    let end_s = simulation.end_time_s();
    let progress = Progress::new(operation.kind.name(), end_s, args.quiet);
    // The run goes on by whole samples.
    let enough_s = end_s - 0.5 * case.dynamics.sample_interval_s;
    let status = loop {
        let time_s = simulation.time_s();
        progress.reach(time_s);
        if time_s >= enough_s {
            break Status::Complete;
        }
        if interrupt.asked() {
            break Status::Interrupted;
        }
        if let Err(diverged) = simulation.advance(LOOK_INTERVAL_S.min(end_s - time_s)) {
            break Status::Failed(diverged.to_string());
        }
    };
    progress.finish();
    record.add_dynamic(
        operation,
        &simulation.outcome(),
        status.clone(),
        start.elapsed(),
    );
    Ok(status)
}

fn unsolvable(model: &str, operation: &Operation, error: &dyn std::error::Error) -> Failure {
    Failure::Failed(format!(
        "error: the {model} has no answer for {}: {error}",
        operation.kind.name()
    ))
}

fn interrupted(folder: &Path) -> Failure {
    Failure::Interrupted(format!(
        "interrupted: what was computed is in {}",
        folder.display()
    ))
}

/// `out/<case name>`, without what some system does not take in a file's name.
fn default_output(name: &str) -> PathBuf {
    const LONGEST: usize = 100;
    let sound: String = name
        .chars()
        .map(|letter| match letter {
            '<' | '>' | ':' | '"' | '/' | '\\' | '|' | '?' | '*' => '-',
            letter if letter.is_control() => '-',
            letter => letter,
        })
        .take(LONGEST)
        .collect();
    // Windows drops dots and blanks at the end, and `.` and `..` are folders already.
    let mut folder = sound.trim_start().trim_end_matches(['.', ' ']).to_owned();
    if folder.is_empty() || is_device(&folder) {
        folder.insert(0, '_');
    }
    Path::new("out").join(folder)
}

/// Whether Windows takes the name for a device, whatever follows its first dot.
fn is_device(name: &str) -> bool {
    let stem = name
        .split('.')
        .next()
        .unwrap_or(name)
        .trim_end()
        .to_ascii_uppercase();
    let numbered = |prefix: &str| {
        stem.strip_prefix(prefix)
            .is_some_and(|rest| rest.len() == 1 && rest.bytes().all(|byte| byte.is_ascii_digit()))
    };
    matches!(stem.as_str(), "CON" | "PRN" | "AUX" | "NUL") || numbered("COM") || numbered("LPT")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn case_names_make_folders_on_every_system() {
        for (name, folder) in [
            ("NP13-X1042 at total depth", "NP13-X1042 at total depth"),
            ("a/b\\c: 12-1/4\" <x>", "a-b-c- 12-1-4- -x-"),
            ("..", "_"),
            ("", "_"),
            (" well. ", "well"),
            ("nul", "_nul"),
            ("Com1.5 m", "_Com1.5 m"),
            ("common", "common"),
            ("Bohrung Süd\n", "Bohrung Süd-"),
        ] {
            assert_eq!(
                default_output(name),
                Path::new("out").join(folder),
                "{name}"
            );
        }
        assert_eq!(default_output(&"é".repeat(500)).as_os_str().len(), 4 + 200);
    }
}
