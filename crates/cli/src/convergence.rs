//! `wholestring run --converge`: change of the results when every element is halved.

use wholestring::outcome::ModelKind;
use wholestring_case::{Case, Override};
use wholestring_results::{OperationSummary, Summary};
use wholestring_runner::{
    ComparedColumn, Comparison, Output,
    run::{self, Outcome, Request},
};
use wholestring_units::UnitSet;

use crate::{
    failure::Failure, input::load, interrupt, progress::RunScreen, run::RunArgs,
    screen_table::Table, shared_args::CaseArgs, stopped::stopped, terminal::print_stdout,
};

/// Folder of the finer run, within that of the run.
const HALVED: &str = "halved";

/// Refuses a case that has no elements to halve.
pub(crate) fn check(case: &Case) -> Result<(), Failure> {
    if case.models.iter().any(|model| *model != ModelKind::Soft) {
        return Ok(());
    }
    Err(Failure::BadInput(
        "error: --converge halves elements, and the soft string, the only model of the case, has \
         none; add \"stiff\" or \"dynamic\" to `model`"
            .to_owned(),
    ))
}

/// Repeats a run, whose results are `base`, with every element halved, and prints both side by
/// side.
pub(crate) fn halve(
    args: &RunArgs,
    case: &Case,
    base: &Outcome,
    units: UnitSet,
) -> Result<(), Failure> {
    let refinement: Override = format!("mesh.refinement={}", 2 * case.dynamics.mesh.refinement)
        .parse()
        .expect("a key and its value");
    let mut overrides = args.case.overrides.clone();
    overrides.push(refinement);
    let finer = load(&CaseArgs { case: args.case.case.clone(), overrides }, true)?;
    let output = Output { folder: Some(base.folder.join(HALVED)), ..args.output() };
    let request = Request {
        output,
        units: Some(units),
        jobs: args.jobs,
        checkpoint_every: args.checkpoint.every,
        csv: args.csv,
        ..Request::new(&finer)
    };
    let screen = RunScreen::new(args.quiet, true);
    let mut halved = run::run(&request, &screen, &interrupt::listen())?;
    if let Some(stop) = halved.stopped.take() {
        return Err(stopped(stop, &halved));
    }
    if args.quiet {
        return Ok(());
    }
    print_stdout(&format!(
        "{}Results with halved elements in {}\n",
        tables(&base.summary, &halved.summary, units),
        halved.folder.display()
    ))
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
