//! The commands that write a results folder: each is a job of the runner, and a screen.

use wholestring_case::Case;
use wholestring_results::{Friction, Summary};
use wholestring_runner::{
    Observer, Silent,
    calibrate::FRAGMENT,
    job::{Job, JobOutcome, OnDisk, PreparedJob, Work},
    run,
};
use wholestring_units::{Dimension, UnitSet};

use crate::{
    bha, bit_test, calibrate, checks, comparison,
    conclusion::{conclude, conclude_judged, refuse, unfinished},
    failure::Failure,
    modes, plan,
    progress::{BatchScreen, RunScreen},
    reach,
    screen::{color, screen_color},
    shared_args::ScreenOptions,
    terminal::{self, print_stderr, print_stdout},
};

/// Executes a job, and prints its results.
pub(crate) fn carry_out(job: &Job, screen: ScreenOptions) -> Result<(), Failure> {
    let prepared = prepare(job, screen.quiet)?;
    let outcome = solve(job, &prepared, screen)?;
    end(job, outcome, screen)
}

/// Reads the inputs of a job, and prints their warnings.
pub(crate) fn prepare(job: &Job, quiet: bool) -> Result<PreparedJob, Failure> {
    let prepared = job.prepare(&OnDisk)?;
    if !quiet {
        for report in prepared.warnings() {
            print_stderr(&report.render(color()));
        }
    }
    Ok(prepared)
}

/// Solves a job, and prints its summary.
pub(crate) fn solve(
    job: &Job,
    prepared: &PreparedJob,
    screen: ScreenOptions,
) -> Result<JobOutcome, Failure> {
    let observer = observer(&job.work, screen);
    let outcome = prepared.run(job.output.clone(), &*observer, &terminal::listen())?;
    // Its bars are removed before results are printed.
    drop(observer);
    if !screen.quiet || screen.json {
        print_stdout(&text(prepared, &outcome, screen)?)?;
    }
    Ok(outcome)
}

/// Prints the counts of a batch, and fails if the job is not complete or, with `--strict`, has
/// errors.
pub(crate) fn end(job: &Job, outcome: JobOutcome, screen: ScreenOptions) -> Result<(), Failure> {
    let errors = outcome.errors();
    let noun = job.work.command().replace('-', " ");
    if let JobOutcome::Sweep(batch) | JobOutcome::Study(batch) = &outcome {
        return conclude_judged(batch, &noun, screen.strict, screen.quiet);
    }
    if let Some((batch, items)) = outcome.batch() {
        conclude(batch, &noun, items, screen.quiet)?;
    }
    unfinished(outcome)?;
    if screen.strict { refuse(&errors) } else { Ok(()) }
}

/// The progress of a job on the screen.
fn observer(work: &Work, screen: ScreenOptions) -> Box<dyn Observer> {
    let quiet = screen.quiet;
    match work {
        Work::Run { .. } => Box::new(RunScreen::new(quiet, quiet || screen.json)),
        Work::Modes { .. } => Box::new(RunScreen::new(quiet, false)),
        Work::Bha(_) => Box::new(Silent),
        Work::Plan { .. } => Box::new(BatchScreen::plan(quiet)),
        Work::Reach(_) => Box::new(BatchScreen::reach(quiet)),
        Work::Calibrate(_) => Box::new(BatchScreen::dynamics(quiet)),
        Work::Sweep(_) => Box::new(BatchScreen::sweep("sweep", quiet)),
        Work::Study(_) => Box::new(BatchScreen::sweep("study", quiet)),
        Work::BitTest { .. } => Box::new(BatchScreen::bit_test(quiet)),
    }
}

/// The summary of a job, with the folder of its results unless [`end`] prints that.
fn text(
    prepared: &PreparedJob,
    outcome: &JobOutcome,
    screen: ScreenOptions,
) -> Result<String, Failure> {
    let units = prepared.units();
    let place = outcome.folder().display();
    Ok(match outcome {
        JobOutcome::Run(outcome) if screen.json => {
            let json = outcome.summary.json().map_err(|error| {
                Failure::Failed(format!("error: the summary cannot be written: {error}"))
            })?;
            format!("{json}\n")
        }
        JobOutcome::Run(outcome) => match prepared.case() {
            Some(case) if !outcome.summary.operations.is_empty() => run_text(case, outcome, units),
            _ => String::new(),
        },
        JobOutcome::Plan(outcome) => plan::text(&outcome.summary, units),
        JobOutcome::Reach(outcome) => {
            let text = reach::text(&outcome.summary, units);
            match outcome.samples {
                Some(_) => text,
                None => {
                    let took_s = outcome.took.as_secs_f64();
                    format!("{text}Found in {took_s:.1} s\nResults in {place}\n")
                }
            }
        }
        JobOutcome::Bha(outcome) => {
            let [alone_s, all_s] = outcome.took_s;
            format!(
                "{}The assembly took {alone_s:.2} s, everything {all_s:.1} s\nResults in {place}\n",
                bha::text(&outcome.summary, units)
            )
        }
        JobOutcome::Modes(outcome) => format!(
            "{}Found in {:.0} ms\nResults in {place}\n",
            modes::text(&outcome.summary, units),
            1e3 * outcome.took.as_secs_f64()
        ),
        JobOutcome::Calibrate(outcome) => format!(
            "{}Found in {:.0} ms\nResults in {place}; {FRAGMENT} there is for the case file\n",
            calibrate::text(&outcome.summary, units),
            1e3 * outcome.took.as_secs_f64()
        ),
        JobOutcome::BitTest(outcome) => bit_test::text(&outcome.summary, units),
        JobOutcome::Sweep(_) | JobOutcome::Study(_) => String::new(),
    })
}

/// The table of a run and its notes.
fn run_text(case: &Case, outcome: &run::Outcome, units: UnitSet) -> String {
    let summary = &outcome.summary;
    let width = terminal_size::terminal_size().map(|(width, _)| usize::from(width.0));
    let title = format!("{}: {}", case.name, subtitle(case, summary, units));
    let table = comparison::table(summary, units, width);
    let notes = comparison::notes(summary, units);
    let checks = checks::lines(summary, units, (width, screen_color()));
    let place = outcome.folder.display();
    format!("{title}\n\n{table}\n{notes}{checks}Results in {place}\n")
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
