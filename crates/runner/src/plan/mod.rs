//! Torque and drag at every depth of the bit, with low, expected and high friction.

mod broomstick;
mod campaign;
mod charts;
mod checks;
mod drawn;
mod dynamic;
mod files;
mod measured;
mod overlay;
pub(crate) mod page;
mod request;
mod rows;
mod sample;
mod work;
mod workbook;

pub use crate::uncertain::{notes, scatter};
pub use broomstick::{BroomstickFound, BroomstickRequest, broomstick};
pub use checks::governing_sentences;
pub use overlay::Overlay;
pub use request::Request;
pub use wholestring_plan::Statics;

use wholestring_report::Plan;
use wholestring_results::{Occupant, PlanSummary, digest};

use self::{
    measured::Measured,
    work::{Ended, Solvers, Work},
};
use crate::{
    batch::BatchOutcome, cancellation::CancellationToken, claim::Claim, error::Error,
    observer::Observer, results_kind::Results, uncertain::Sampler,
};

// Execution and outcome of a plan.

/// Outcome of a plan.
#[derive(Debug)]
pub struct Outcome {
    /// Results, as in `summary.json`.
    pub summary: PlanSummary,
    /// Number of finished tasks.
    pub batch: BatchOutcome,
}

/// Solves every operation at every depth with every friction level, and writes the tables, the
/// pictures, the page and the workbook. A point without a solution is a row with the reason.
///
/// # Errors
/// A folder that cannot take the results.
pub fn run(
    request: &Request<'_>,
    observer: &dyn Observer,
    cancellation: &CancellationToken,
) -> Result<Outcome, Error> {
    let case = request.case;
    let broomstick = case.broomstick().map_err(Error::failed)?;
    let measured = Measured::of(request, observer, cancellation)?;
    let read = case.plan.measured.as_ref();
    let identity = digest(&(
        case.identity(),
        &case.plan,
        read.map(|measurements| format!("{measurements:?}")),
    ));
    let name = format!("{} plan", case.name);
    let occupant = Occupant { kind: "plan".into(), name, identity: identity.clone() };
    let claimed = Claim {
        is_unfinished: &|path| path.join("checkpoint.bin").is_file(),
        ..Claim::new(occupant, &request.output, observer)
    }
    .folder()?;
    let folder = &claimed.folder;
    if let Some(read) = read {
        observer.note(&format!("{}: {}", read.file, read.notes.join("; ")));
    }
    let sampler = Sampler::of(case, request.template, request.overrides);
    let solvers =
        Solvers { broomstick: &broomstick, measured: &measured, sampler: sampler.as_ref() };
    let work = Work::new(request, solvers, identity, folder, observer, cancellation)?;
    work.solve_all()?;
    let Ended { mut summary, tables, batch } = work.end();
    if let Some(overlay) = &request.overlay {
        let (laid_over, without) = overlay.laid_over(&summary);
        let notes: Vec<String> = overlay.notes.iter().chain(&without).cloned().collect();
        observer.note(&format!("{}: {}", overlay.file, notes.join("; ")));
        summary.overlay = Some(laid_over);
    }
    files::write(folder, &summary, &tables)?;
    let units = request.units.unwrap_or(case.units);
    Plan::gather(folder.path(), Some(units))?.write(folder, request.png)?;
    page::write_workbook(folder, &summary, &tables, units)?;
    Ok(Outcome { summary, batch })
}
