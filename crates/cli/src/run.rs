//! `wholestring run`: solves a case, prints one table and writes the results.

use std::path::Path;

use wholestring_case::Case;
use wholestring_results::{ResultsFolder, Status, Summary};

use crate::{
    args::RunArgs,
    bit_table,
    checkpoint::Laid,
    comparison,
    cores::Cores,
    failure::Failure,
    folder_name::default_output,
    indicators,
    interrupt::Interrupt,
    keep::Keep,
    load,
    progress::Watch,
    record::{self, Record},
    report, rig, say,
    solve::{Way, checkpoint_every, solve},
};

pub(crate) fn run(args: &RunArgs) -> Result<(), Failure> {
    let case = load(&args.case, args.quiet)?;
    let units = args.units.unwrap_or(case.units);
    let (folder, mut record, under_way) = match &args.resume {
        Some(path) => {
            let folder = existing(path)?;
            let laid = laid_aside(&folder, &case)?;
            let record = Record::resume(&case, units, &folder, laid.solved).map_err(begin_anew)?;
            (folder, record, laid.under_way)
        }
        None => {
            let output = args.output.clone();
            let output = output.unwrap_or_else(|| default_output(&case.name));
            // Before anything is solved, so that a long run does not end on a folder it may not write to.
            let folder = ResultsFolder::create(output)?;
            let record = Record::begin(&case, units, &folder)?;
            (folder, record, None)
        }
    };
    let way = Way {
        keep: Keep::All,
        csv: args.csv,
        checkpoint_every: args.checkpoint.unwrap_or_else(|| checkpoint_every(&case)),
        watch: Watch::Screen { quiet: args.quiet },
        interrupt: &Interrupt::listen(),
        crew: Cores::for_rock(&case, args.jobs),
    };
    let solved = solve(&case, &way, &mut record, &folder, under_way);
    if !args.quiet && !record.summary.operations.is_empty() {
        let width = terminal_size::terminal_size().map(|(width, _)| usize::from(width.0));
        let title = format!("{}: {}", case.name, record::subtitle(&case, units));
        let table = comparison::table(&record.summary, units, width);
        let notes = comparison::notes(&record.summary, units);
        let indicators = indicators::notes(&record.summary, units);
        let warnings = rig::warnings(&record.summary, &case.model.rig, units)
            + &bit_table::warnings(&record.summary, units);
        let place = folder.path().display();
        say(&format!(
            "{title}

{table}
{notes}{indicators}{warnings}Results in {place}
"
        ))?;
    }
    // The page is made from the files: what they hold need not be held beside it.
    drop(record);
    let reported = report::write(&folder, units);
    solved.map_err(|stop| stop.failure(&folder))?;
    reported
}

fn bad(reason: impl std::fmt::Display) -> Failure {
    Failure::BadInput(format!("error: {reason}"))
}

/// Why a run cannot go on, with the way out.
fn begin_anew(reason: String) -> Failure {
    bad(format!(
        "{reason}\nrun the case without --resume to begin anew"
    ))
}

/// The folder of a run that is to be resumed.
fn existing(path: &Path) -> Result<ResultsFolder, Failure> {
    if !path.is_dir() {
        return Err(bad(format!("there is no folder {}", path.display())));
    }
    Ok(ResultsFolder::create(path)?)
}

/// The run that was laid aside in the folder, or why there is none.
fn laid_aside(folder: &ResultsFolder, case: &Case) -> Result<Laid<'static>, Failure> {
    let place = folder.path().display();
    match Laid::read(folder, case) {
        Ok(Some(laid)) => return Ok(laid),
        Ok(None) => {}
        Err(reason) => return Err(begin_anew(reason)),
    }
    let summary = Summary::read(&folder.path().join("summary.json")).ok();
    let statuses = summary.iter().flat_map(|summary| &summary.operations);
    let last = statuses.map(|solved| &solved.status).next_back();
    Err(match last {
        Some(Status::Complete) => bad(format!(
            "the run in {place} is finished: nothing is left to do"
        )),
        Some(Status::Failed(reason)) => bad(format!(
            "the run in {place} failed and would fail again: {reason}"
        )),
        _ => begin_anew(format!("there is no checkpoint in {place}")),
    })
}
