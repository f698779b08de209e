//! `wholestring check`: is the case sound?

use wholestring::outcome::ModelKind;
use wholestring_case::Case;
use wholestring_units::Dimension;

use crate::{args::CheckArgs, failure::Failure, load, say};

pub(crate) fn check(args: &CheckArgs) -> Result<(), Failure> {
    let case = load(&args.case, false)?;
    say(&format!(
        "{} is sound: {}\n",
        args.case.case.display(),
        outline(&case)
    ))
}

/// What a run of the case would solve, in a line.
fn outline(case: &Case) -> String {
    let models = case.models.iter().copied().map(ModelKind::name);
    let operations = case
        .operations
        .iter()
        .map(|operation| operation.kind.name());
    let depth = case
        .operations
        .first()
        .map_or(0.0, |operation| operation.bit_depth_m);
    format!(
        "{}; {}; bit at {}",
        list(operations),
        list(models),
        Dimension::Length.format(depth, case.units),
    )
}

fn list<'a>(names: impl Iterator<Item = &'a str>) -> String {
    names.collect::<Vec<_>>().join(", ")
}
