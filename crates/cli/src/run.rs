//! `wholestring run`: solves a case, prints one table and writes the results.

use std::{num::NonZeroUsize, path::PathBuf};

use clap::Args;
use wholestring::outcome::ModelKind;
use wholestring_results::{OperationSummary, Summary};
use wholestring_runner::{
    ComparedColumn, Comparison,
    job::{Job, JobOutcome, PreparedJob, Work},
};
use wholestring_units::UnitSet;

use crate::{
    conclusion::unfinished,
    failure::{Failure, failed},
    progress::RunScreen,
    screen::Table,
    shared_args::{CaseArgs, CheckpointArgs, ScreenOptions, output},
    terminal::{self, print_stdout},
    work::{carry_out, end, prepare, solve},
};

pub(crate) fn run(args: &RunArgs) -> Result<(), Failure> {
    let (job, screen) = (args.job(), args.screen());
    if !args.converge {
        return carry_out(&job, screen);
    }
    let prepared = prepare(&job, screen.quiet)?;
    check_convergence(&prepared)?;
    let base = solve(&job, &prepared, screen)?;
    halve(&job, &prepared, &base, screen)?;
    end(&job, base, screen)
}

// Arguments of `wholestring run`.

#[derive(Debug, Args)]
pub(crate) struct RunArgs {
    #[command(flatten)]
    pub(crate) case: CaseArgs,

    // Not a doc comment, which would read `<case name>` as HTML.
    #[arg(
        short,
        long,
        value_name = "DIR",
        help = "Folder for the results [default: out/<case name>]"
    )]
    pub(crate) output: Option<PathBuf>,

    /// Continue with the run in this folder from its checkpoint
    #[arg(long, value_name = "DIR", conflicts_with_all = ["output", "overwrite"])]
    pub(crate) resume: Option<PathBuf>,

    /// Overwrite existing results in the folder: another case or an unfinished run
    #[arg(long)]
    pub(crate) overwrite: bool,

    #[command(flatten)]
    pub(crate) checkpoint: CheckpointArgs,

    /// Run the case again with elements of half the length, in the subfolder `halved`, and print
    /// the differences
    #[arg(long, conflicts_with_all = ["resume", "json"])]
    converge: bool,

    /// Number of threads for the solid rock under the bit; results do not depend on it [default:
    /// one per core]
    #[arg(short, long, value_name = "N")]
    pub(crate) jobs: Option<NonZeroUsize>,

    /// Units on the screen [default: the case's]
    #[arg(long, value_name = "si|metric|field")]
    pub(crate) units: Option<UnitSet>,

    /// Exit with status 4 if a check of the results is an error
    #[arg(long)]
    pub(crate) strict: bool,

    /// Also write the tables as CSV
    #[arg(long)]
    pub(crate) csv: bool,

    /// Print the summary as JSON in place of the table
    #[arg(long)]
    pub(crate) json: bool,

    /// Print nothing but errors
    #[arg(short, long)]
    pub(crate) quiet: bool,
}

impl RunArgs {
    /// The job of these arguments.
    pub(crate) fn job(&self) -> Job {
        let folder = self.resume.as_ref().or(self.output.as_ref());
        Job {
            output: output(folder, self.resume.is_some(), self.overwrite),
            units: self.units,
            jobs: self.jobs,
            checkpoint: self.checkpoint.every.clone(),
            ..self.case.job(Work::Run { models: Vec::new(), csv: self.csv })
        }
    }

    /// Options of the screen.
    pub(crate) fn screen(&self) -> ScreenOptions {
        ScreenOptions { quiet: self.quiet, strict: self.strict, json: self.json }
    }
}

// `wholestring run --converge`: change of the results when every element is halved.

/// Folder of the finer run, within that of the run.
const HALVED: &str = "halved";

/// Refuses a case that has no elements to halve.
fn check_convergence(prepared: &PreparedJob) -> Result<(), Failure> {
    let mut models = prepared.case().into_iter().flat_map(|case| &case.models);
    if models.any(|model| *model != ModelKind::Soft) {
        return Ok(());
    }
    Err(Failure::BadInput(
        "error: --converge halves elements, and the soft string, the only model of the case, has \
         none; add \"stiff\" or \"dynamic\" to `model`"
            .to_owned(),
    ))
}

/// Repeats a run that is complete, with every element halved, and prints both side by side.
fn halve(
    job: &Job,
    prepared: &PreparedJob,
    base: &JobOutcome,
    screen: ScreenOptions,
) -> Result<(), Failure> {
    let (JobOutcome::Run(base), Some(case)) = (base, prepared.case()) else { return Ok(()) };
    if base.stopped.is_some() {
        return Ok(());
    }
    let refinement = format!("mesh.refinement={}", 2 * case.dynamics.mesh.refinement);
    let mut finer = job.clone();
    finer.set.push(refinement.parse().map_err(|error| failed(&error))?);
    finer.output.folder = Some(base.folder.join(HALVED));
    let solved = prepare(&finer, true)?;
    let observer = RunScreen::new(screen.quiet, true);
    let outcome = solved.run(finer.output.clone(), &observer, &terminal::listen())?;
    drop(observer);
    if let (JobOutcome::Run(halved), false) = (&outcome, screen.quiet)
        && halved.stopped.is_none()
    {
        print_stdout(&format!(
            "{}Results with halved elements in {}\n",
            tables(&base.summary, &halved.summary, prepared.units()),
            halved.folder.display()
        ))?;
    }
    unfinished(outcome)
}

/// A table for each operation that has elements.
fn tables(base: &Summary, halved: &Summary, units: UnitSet) -> String {
    let [one, two] = [base, halved].map(|summary| Comparison::of(summary, units));
    let operations = base.operations.iter().zip(&halved.operations);
    let columns = one.columns.iter().zip(&two.columns);
    let mut text = String::new();
    for ((base, halved), (before, after)) in operations.zip(columns) {
        let [Some(coarse), Some(fine)] = [base, halved].map(elements) else {
            continue;
        };
        let name = format!("{} ({})", base.operation.name(), base.model);
        let title = format!("{name}: {coarse} elements as given, {fine} halved");
        text += &table(&title, &one, before, after);
        text.push('\n');
    }
    text
}

fn elements(operation: &OperationSummary) -> Option<usize> {
    let in_time = operation.numerics.as_ref().map(|numerics| numerics.run.elements);
    in_time.or_else(|| Some(operation.at_rest.as_ref()?.convergence.elements))
}

fn table(title: &str, rows: &Comparison, base: &ComparedColumn, halved: &ComparedColumn) -> String {
    let headings = ["", "", "as given", "halved", "change", "std as given", "std halved"];
    let mut table = Table::new(title, 2, &headings);
    for (index, row) in rows.rows.iter().enumerate() {
        let (Some(before), Some(after)) = (base.values[index], halved.values[index]) else {
            continue;
        };
        let number = |value: f64| format!("{value:.0$}", row.decimals);
        let std = |column: &ComparedColumn| {
            let deviation = column.deviations.as_ref().and_then(|deviation| deviation[index]);
            deviation.map_or_else(String::new, |deviation| {
                format!("{:.1$}", deviation.std, row.decimals + 1)
            })
        };
        table.row(vec![
            row.label.to_owned(),
            row.symbol.to_owned(),
            number(before),
            number(after),
            change(before, after, row.decimals),
            std(base),
            std(halved),
        ]);
    }
    table.text()
}

/// A change in percent of the first value; none if that value prints as zero.
fn change(before: f64, after: f64, decimals: usize) -> String {
    let least = 0.5 * 0.1_f64.powi(decimals as i32);
    if before.abs() < least {
        String::new()
    } else {
        format!("{:+.2} %", 100.0 * (after - before) / before.abs())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_change_is_of_what_was() {
        assert_eq!(change(200.0, 201.0, 1), "+0.50 %");
        assert_eq!(change(-200.0, -201.0, 1), "-0.50 %");
        assert_eq!(change(3.0, 3.0, 1), "+0.00 %");
        assert_eq!(change(0.0, 1.0, 1), "");
        assert_eq!(change(0.0004, -0.0004, 3), "");
    }
}
