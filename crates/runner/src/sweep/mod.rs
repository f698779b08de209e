//! `wholestring sweep`: solves a case for all combinations of some values.

mod batch;
mod checked;
mod points;
#[path = "page.rs"]
pub(crate) mod report;
mod table;

use wholestring_case::{Report, Template, Variation};

pub(crate) use self::{
    batch::{Batch, Ending, Set, Sound},
    points::{Point, points},
    table::SCALARS,
};
use crate::{args::SweepArgs, color, failure::Failure, keep::Keep};

pub(crate) fn sweep(args: &SweepArgs) -> Result<(), Failure> {
    let refused = |report: Report| Failure::BadInput(report.render(color()));
    args.kept.check(&args.batch)?;
    let variations = Variation::read_all(&args.vary).map_err(refused)?;
    let template = Template::read(&args.case.case).map_err(refused)?;
    let points = points(&template, &args.case.overrides, &variations)?;
    let sound = Sound::check(points, &args.batch)?;
    let name = format!("{} sweep", sound.first_name());
    let claimed = sound.claim("sweep", &name, &args.batch, &|path, _| path.to_owned())?;
    let set = Set {
        prefix: String::new(),
        folder: claimed.folder.clone(),
        keys: variations.into_iter().map(|of| of.key).collect(),
        keep: args.kept.keep,
        needs: Keep::Summary,
    };
    let place = set.folder.path().to_owned();
    let mut batch = Batch::new("sweep", &args.batch, vec![set], sound);
    batch.solve_all()?;
    batch.conclude(&place, args.strict)
}
