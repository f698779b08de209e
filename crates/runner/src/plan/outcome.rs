//! What comes of a plan.

use wholestring_report::Plan;
use wholestring_results::{Occupant, PlanSummary, digest};

use super::{
    files, page,
    request::Request,
    work::{Ended, Work},
};
use crate::{
    batch::BatchOutcome, cancellation::CancellationToken, claim::Claim, error::Error,
    observer::Observer, results_kind::Results, uncertain::Sampler,
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
    let identity = digest(&(case.identity(), &case.plan));
    let name = format!("{} plan", case.name);
    let occupant = Occupant { kind: "plan".into(), name, identity: identity.clone() };
    let claimed = Claim {
        is_unfinished: &|path| path.join("checkpoint.bin").is_file(),
        ..Claim::new(occupant, &request.output, observer)
    }
    .folder()?;
    let folder = &claimed.folder;
    let sampler = Sampler::of(case, request.template, request.overrides);
    let of = (&broomstick, sampler.as_ref());
    let work = Work::new(request, of, identity, folder, observer, cancellation)?;
    work.solve_all()?;
    let Ended { summary, tables, batch } = work.end();
    files::write(folder, &summary, &tables)?;
    let units = request.units.unwrap_or(case.units);
    Plan::gather(folder.path(), Some(units))?.write(folder, request.png)?;
    page::write_workbook(folder, &summary, &tables, units)?;
    Ok(Outcome { summary, batch })
}
