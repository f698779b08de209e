//! What comes of a plan.

use wholestring_results::{Occupant, PlanSummary, digest};

use super::{
    files,
    measured::Measured,
    page,
    request::Request,
    work::{Ended, Work},
};
use crate::{
    batch::BatchOutcome, cancellation::CancellationToken, claim::Claim, error::Error,
    folder_name::default_output, observer::Observer,
};

/// What came of it.
#[derive(Debug)]
pub struct Outcome {
    /// What was found, as `summary.json` has it.
    pub summary: PlanSummary,
    /// How much of it is finished.
    pub batch: BatchOutcome,
}

/// Solves every operation at every depth with every friction, and writes the tables, the pictures,
/// the page and the workbook. What has no answer is a row with its reason.
///
/// # Errors
/// A folder that the results cannot go to.
pub fn run(
    request: &Request<'_>,
    observer: &dyn Observer,
    cancellation: &CancellationToken,
) -> Result<Outcome, Error> {
    let case = request.case;
    let broomstick = case.broomstick().map_err(Error::failed)?;
    let measured = Measured::of(request)?;
    let read = case.plan.measured.as_ref();
    let identity = digest(&(case.identity(), &case.plan, read.map(|of| format!("{of:?}"))));
    let name = format!("{} plan", case.name);
    let claimed = Claim {
        occupant: Occupant { kind: "plan".into(), name: name.clone(), identity: identity.clone() },
        output: &request.output,
        default: default_output(&name),
        shared: false,
        observer,
        is_unfinished: &|path| path.join("checkpoint.bin").is_file(),
        is_part: &|_| false,
        refuse: &|_| Ok(()),
    }
    .folder()?;
    let folder = &claimed.folder;
    if let Some(read) = read {
        observer.note(&format!("{}: {}", read.file, read.notes.join("; ")));
    }
    let work =
        Work::new(request, (&broomstick, &measured), identity, folder, observer, cancellation)?;
    work.solve_all()?;
    let Ended { summary, tables, batch } = work.end();
    files::write(folder, &summary, &tables)?;
    let units = request.units.unwrap_or(case.units);
    page::write(folder, &page::gather(folder.path(), Some(units))?, request.png)?;
    page::write_workbook(folder, &summary, &tables, units)?;
    Ok(Outcome { summary, batch })
}
