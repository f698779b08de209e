//! `wholestring run`: solves a case, prints one table and writes the results.

use std::path::Path;

use wholestring_case::Case;
use wholestring_results::{Occupant, ResultsFolder, Status, Summary, digest};

use crate::{
    args::RunArgs,
    checkpoint::{Laid, is_of},
    claim::{self, Claim},
    comparison, cores,
    failure::Failure,
    findings,
    folder_name::default_output,
    interrupt::Interrupt,
    keep::Keep,
    load,
    progress::Watch,
    record::{self, Record},
    report, say, screen_color,
    solve::{Way, checkpoint_every, solve},
};

pub(crate) fn run(args: &RunArgs) -> Result<(), Failure> {
    let case = load(&args.case, args.quiet)?;
    let units = args.units.unwrap_or(case.units);
    let occupant = Occupant {
        kind: "run".into(),
        name: case.name.clone(),
        identity: digest(&case.identity()),
    };
    let (claimed, mut record, under_way) = match &args.resume {
        Some(path) => {
            let folder = existing(path)?;
            let claimed = claim::hold(&folder)?;
            let laid = laid_aside(&folder, &case)?;
            let record = Record::resume(&case, units, &folder, laid.solved).map_err(begin_anew)?;
            (claimed.occupy(&occupant)?, record, laid.under_way)
        }
        None => {
            // Before anything is solved, so that a long run does not end on a folder it may not write to.
            let claimed = Claim {
                occupant,
                output: args.output.as_deref(),
                default: default_output(&case.name),
                shared: false,
                resume: false,
                overwrite: args.overwrite,
                quiet: args.quiet || args.json,
                is_unfinished: &|path| path.join("checkpoint.bin").is_file(),
                is_part: &|_| false,
                go_on: &|path| format!("run the case with --resume {}", path.display()),
                refuse: &|_| Ok(()),
            }
            .folder()?;
            let record = Record::begin(&case, units, &claimed.folder)?;
            (claimed, record, None)
        }
    };
    let folder = &claimed.folder;
    let interrupt = Interrupt::listen();
    let way = Way {
        keep: Keep::All,
        csv: args.csv,
        checkpoint_every: args.checkpoint.unwrap_or_else(|| checkpoint_every(&case)),
        watch: Watch::Screen { quiet: args.quiet },
        interrupt: &interrupt,
        crew: cores::for_rock(&case, args.jobs, &interrupt),
    };
    let solved = solve(&case, &way, &mut record, folder, under_way);
    if args.json {
        let summary = record.summary.json().map_err(|error| {
            Failure::Failed(format!("error: the summary cannot be written: {error}"))
        })?;
        say(&format!("{summary}\n"))?;
    } else if !args.quiet && !record.summary.operations.is_empty() {
        let width = terminal_size::terminal_size().map(|(width, _)| usize::from(width.0));
        let title = format!("{}: {}", case.name, record::subtitle(&case, units));
        let table = comparison::table(&record.summary, units, width);
        let notes = comparison::notes(&record.summary, units);
        let findings = findings::lines(&record.summary, width, screen_color());
        let place = folder.path().display();
        say(&format!(
            "{title}

{table}
{notes}{findings}Results in {place}
"
        ))?;
    }
    let refused = findings::refused(&record.summary).filter(|_| args.strict);
    // The page is made from the files: what they hold need not be held beside it.
    drop(record);
    let reported = report::write(folder, units);
    solved.map_err(|stop| stop.failure(folder))?;
    reported?;
    refused.map_or(Ok(()), Err)
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
    let Ok(summary) = Summary::read(&folder.path().join("summary.json")) else {
        return Err(begin_anew(format!("there is no checkpoint in {place}")));
    };
    if let Err(reason) = is_of(&summary, case) {
        return Err(begin_anew(format!(
            "there is no checkpoint in {place}, and what lies there cannot be gone on with: {reason}"
        )));
    }
    let failed = summary.operations.iter().find_map(|of| match &of.status {
        Status::Failed(reason) => Some(reason),
        _ => None,
    });
    if let Some(reason) = failed {
        return Err(bad(format!(
            "the run in {place} failed and would fail again: {reason}"
        )));
    }
    let complete = summary.operations.iter();
    let complete = complete.filter(|of| of.status == Status::Complete).count();
    let all = case.operations.len() * case.models.len();
    Err(if complete == all {
        bad(format!(
            "the run in {place} is finished: nothing is left to do"
        ))
    } else {
        begin_anew(format!(
            "there is no checkpoint in {place}: the run ended before its first one, with {complete} of {all} answers"
        ))
    })
}
