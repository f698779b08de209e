//! `wholestring bit-test`: the bit alone on its rock, under every weight at every speed.

mod laid;
pub(crate) mod page;
mod points;
#[path = "../../../cli/src/bit_test/screen.rs"]
mod screen;
mod tables;
mod trials;

use std::path::Path;

use wholestring_case::Case;
use wholestring_results::{BitTestSummary, Occupant, digest};

use self::{points::common, trials::Trials};
use crate::{
    args::{BitTestArgs, Shard},
    checkpoint::difference,
    claim::Claim,
    failure::Failure,
    folder_name::default_output,
    load, say,
};

pub(crate) fn bit_test(args: &BitTestArgs) -> Result<(), Failure> {
    let case = load(&args.case, args.batch.quiet)?;
    let Some(test) = &case.bit_test else {
        return Err(bad(
            "the case has no rock to try its bit on: give it [rock] and [bit_test]",
        ));
    };
    let points = points::points(test, &case.settings)?;
    let name = format!("{} bit test", case.name);
    let shard = args.batch.shard.unwrap_or(Shard::ALL);
    let parts: Vec<_> = points.iter().map(|of| (&of.name, &of.settings)).collect();
    // Before anything is drilled, so that a long test does not end on a folder it may not write to.
    let claimed = Claim {
        occupant: Occupant {
            kind: "bit test".into(),
            name: name.clone(),
            identity: digest(&parts),
        },
        output: args.batch.output.as_deref(),
        default: default_output(&name),
        shared: shard != Shard::ALL,
        resume: args.batch.resume,
        overwrite: args.batch.overwrite,
        quiet: args.batch.quiet,
        is_unfinished: &|path| {
            let mine = (0..points.len()).filter(|point| shard.has(*point));
            let mut places = mine.map(|point| path.join(&points[point].name));
            places.any(|place| place.join("checkpoint.bin").is_file())
        },
        is_part: &|_| true,
        go_on: &|_| "add --resume".to_owned(),
        refuse: &|path| match args.batch.resume {
            true => check_same(path, &case),
            false => Ok(()),
        },
    }
    .folder()?;
    let trials = Trials::new(&args.batch, &case, test, points, claimed.folder.clone())?;
    trials.solve_all()?;
    let units = args.units.unwrap_or(case.units);
    if !args.batch.quiet {
        say(&screen::text(&trials.summary(), units))?;
    }
    let folder = trials.folder();
    page::write(folder, &page::gather(folder.path(), Some(units))?)?;
    trials.conclude()
}

fn bad(reason: impl std::fmt::Display) -> Failure {
    Failure::BadInput(format!("error: {reason}"))
}

/// Refuses to go on in a folder with another test's points.
fn check_same(folder: &Path, case: &Case) -> Result<(), Failure> {
    let path = folder.join("summary.json");
    if !path.is_file() {
        return Ok(());
    }
    let place = folder.display();
    let again = "run the test without --resume to begin anew";
    let there = BitTestSummary::read(&path)
        .map_err(|error| bad(format_args!("{place} is no folder of a bit test: {error}")))?;
    match difference(&common(&there.settings), &common(&case.settings)) {
        None => Ok(()),
        Some(difference) => Err(bad(format_args!(
            "the points in {place} are of another test: {difference}\n{again}"
        ))),
    }
}
