//! `wholestring run`: solves a case, prints one table and writes the results.

mod args;

use wholestring_case::Case;
use wholestring_results::{Friction, Summary};
use wholestring_runner::{
    checks::{has_error, name},
    run::{self, Outcome, Request},
};
use wholestring_units::{Dimension, UnitSet};

use crate::{
    checks, color::screen_color, comparison, convergence, failure::Failure, input::load, interrupt,
    progress::RunScreen, stopped::stopped, terminal::print_stdout,
};

pub(crate) use args::RunArgs;

pub(crate) fn run(args: &RunArgs) -> Result<(), Failure> {
    let case = load(&args.case, args.quiet)?;
    if args.converge {
        convergence::check(&case)?;
    }
    let units = args.units.unwrap_or(case.units);
    let request = Request {
        case: &case,
        output: args.output(),
        units: Some(units),
        jobs: args.jobs,
        checkpoint_every: args.checkpoint.every,
        csv: args.csv,
    };
    let screen = RunScreen::new(args.quiet, args.quiet || args.json);
    let mut outcome = run::run(&request, &screen, &interrupt::listen())?;
    if args.json {
        let summary = outcome.summary.json().map_err(|error| {
            Failure::Failed(format!("error: the summary cannot be written: {error}"))
        })?;
        print_stdout(&format!("{summary}\n"))?;
    } else if !args.quiet && !outcome.summary.operations.is_empty() {
        show(&case, &outcome, units)?;
    }
    match outcome.stopped.take() {
        Some(stop) => return Err(stopped(stop, &outcome)),
        None if args.converge => convergence::halve(args, &case, &outcome, units)?,
        None => {}
    }
    if args.strict { refuse(&outcome.summary) } else { Ok(()) }
}

/// Prints the table and its notes.
fn show(case: &Case, outcome: &Outcome, units: UnitSet) -> Result<(), Failure> {
    let summary = &outcome.summary;
    let width = terminal_size::terminal_size().map(|(width, _)| usize::from(width.0));
    let title = format!("{}: {}", case.name, subtitle(case, summary, units));
    let table = comparison::table(summary, units, width);
    let notes = comparison::notes(summary, units);
    let checks = checks::lines(summary, units, (width, screen_color()));
    let place = outcome.folder.display();
    print_stdout(&format!(
        "{title}

{table}
{notes}{checks}Results in {place}
"
    ))
}

/// `bit at 4305 m, friction 0.3, mud 1200 kg/m3`
fn subtitle(case: &Case, summary: &Summary, units: UnitSet) -> String {
    let depth = case.operations.first().map_or(0.0, |operation| operation.bit_depth_m);
    let friction = match summary.operations.first().map(|operation| &operation.friction) {
        Some(Friction::Uniform(value)) => value.to_string(),
        Some(Friction::BySection(values)) => {
            values.iter().map(f64::to_string).collect::<Vec<_>>().join(", ")
        }
        None => String::new(),
    };
    format!(
        "bit at {}, friction {friction}, mud {}",
        Dimension::Length.format(depth, units),
        Dimension::Density.format(case.model.mud.density_kg_per_m3, units),
    )
}

/// The reason why `--strict` rejects a run, if it does.
fn refuse(summary: &Summary) -> Result<(), Failure> {
    let wrong = summary.operations.iter().filter(|operation| has_error(operation));
    let wrong: Vec<String> = wrong.map(name).collect();
    match wrong.is_empty() {
        true => Ok(()),
        false => Err(Failure::Refused(format!("error: errors were found: {}", wrong.join(", ")))),
    }
}
