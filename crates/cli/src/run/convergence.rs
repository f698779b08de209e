//! `wholestring run --converge`: change of the results when every element is halved.

use wholestring::outcome::ModelKind;
use wholestring_results::{OperationSummary, Summary};
use wholestring_runner::{
    ComparedColumn, Comparison,
    job::{Job, JobOutcome, PreparedJob},
};
use wholestring_units::UnitSet;

use crate::{
    conclusion::unfinished,
    failure::{Failure, failed},
    interrupt,
    progress::RunScreen,
    screen_table::Table,
    shared_args::ScreenOptions,
    terminal::print_stdout,
    work::prepare,
};

/// Folder of the finer run, within that of the run.
const HALVED: &str = "halved";

/// Refuses a case that has no elements to halve.
pub(super) fn check(prepared: &PreparedJob) -> Result<(), Failure> {
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
pub(super) fn halve(
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
    let outcome = solved.run(finer.output.clone(), &observer, &interrupt::listen())?;
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
