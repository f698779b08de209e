//! A bit test: the bit alone on its rock, at every weight and every speed.

mod points;
mod tables;
mod trials;

use std::path::Path;

use wholestring_case::Case;
use wholestring_report::BitTest;
use wholestring_results::{BitTestSummary, Occupant, bit_test_common, digest};
use wholestring_units::UnitSet;

use self::{points::points, trials::Trials};
use crate::{
    batch::{BatchOptions, BatchOutcome},
    cancellation::CancellationToken,
    checkpoint::difference,
    claim::Claim,
    error::Error,
    observer::Observer,
    output::Existing,
    results_kind::Results,
    share::Share,
};

// Request of a bit test, and its outcome.

/// Request to test the bit of a case on its rock.
#[derive(Debug)]
pub struct Request<'a> {
    /// The case.
    pub case: &'a Case,
    /// Units of the picture and the page; by default those of the case.
    pub units: Option<UnitSet>,
    /// Options for drilling the points.
    pub batch: BatchOptions,
}

/// Outcome of a bit test.
#[derive(Debug)]
pub struct Outcome {
    /// Results, as in `summary.json`.
    pub summary: BitTestSummary,
    /// Counts of the points.
    pub batch: BatchOutcome,
}

/// Drills every point of a case's bit test, and writes its tables, picture and page.
///
/// # Errors
/// A case without a rock, or a folder that cannot take the results. The state of the points is in
/// the outcome.
pub fn run(
    request: &Request<'_>,
    observer: &dyn Observer,
    cancellation: &CancellationToken,
) -> Result<Outcome, Error> {
    let (case, options) = (request.case, &request.batch);
    let Some(test) = &case.bit_test else {
        return Err(Error::BadInput(
            "the case has no rock to try its bit on: give it [rock] and [bit_test]".to_owned(),
        ));
    };
    let points = points(test, &case.settings)?;
    let name = format!("{} bit test", case.name);
    let parts: Vec<_> = points.iter().map(|point| (&point.name, &point.settings)).collect();
    // Checked before drilling, so that a long test does not fail at its end on a folder that it may
    // not write to.
    let occupant = Occupant { kind: "bit test".into(), name, identity: digest(&parts) };
    let claimed = Claim {
        shared: options.shard.is_part(),
        is_unfinished: &|path| {
            let mine = (0..points.len()).filter(|point| options.shard.has(*point));
            let mut places = mine.map(|point| path.join(&points[point].name));
            places.any(|place| place.join("checkpoint.bin").is_file())
        },
        is_part: &|_| true,
        refuse: &|path| match options.output.existing {
            Existing::Resume => check_same(path, case),
            Existing::Protect | Existing::Overwrite => Ok(()),
        },
        ..Claim::new(occupant, &options.output, observer)
    }
    .folder()?;
    let folder = &claimed.folder;
    let share = Share::begin(&claimed, options.shard)?;
    let mut trials =
        Trials::new(options, share, case, test, points, folder.clone(), observer, cancellation)?;
    trials.solve_all()?;
    let units = request.units.unwrap_or(case.units);
    let summary = trials.summary();
    BitTest::gather(folder.path(), Some(units))?.write(folder, false)?;
    let batch = trials.outcome();
    Ok(Outcome { summary, batch })
}

/// Refuses to continue in a folder that contains points of another test.
fn check_same(folder: &Path, case: &Case) -> Result<(), Error> {
    let path = folder.join("summary.json");
    if !path.is_file() {
        return Ok(());
    }
    let place = folder.display();
    let there = BitTestSummary::read(&path)
        .map_err(|error| Error::BadInput(format!("{place} is no folder of a bit test: {error}")))?;
    match difference(&bit_test_common(&there.settings), &bit_test_common(&case.settings)) {
        None => Ok(()),
        Some(difference) => Err(Error::NotResumable {
            noun: "test",
            reason: format!("the points in {place} are of another test: {difference}"),
        }),
    }
}
