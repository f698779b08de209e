//! `wholestring reach`: how far the well can go, and what stops it.

mod screen;

use wholestring::operation::OperationKind;
use wholestring_case::read_values;
use wholestring_runner::{
    Existing, Output, Silent,
    reach::{self, Request},
};
use wholestring_units::Dimension;

use crate::{
    args::ReachArgs, color::color, failure::Failure, input::load, interrupt, terminal::print_stdout,
};

pub(crate) fn reach(args: &ReachArgs) -> Result<(), Failure> {
    let depth = |option: &str, text: &Option<String>| -> Result<Option<f64>, Failure> {
        match values(option, text.as_deref(), Dimension::Length)?.as_slice() {
            [] => Ok(None),
            [depth_m] => Ok(Some(*depth_m)),
            _ => Err(Failure::BadInput(format!("error: {option} takes one depth"))),
        }
    };
    let (from_m, to_m) = (depth("--from", &args.from)?, depth("--to", &args.to)?);
    let frictions = args.friction.iter().flat_map(|list| list.split(','));
    let frictions = frictions.map(|text| friction(text.trim())).collect::<Result<_, _>>()?;
    let operations = args.operation.iter().flat_map(|list| list.split(','));
    let operations = operations.map(|name| operation(name.trim())).collect::<Result<_, _>>()?;
    let case = load(&args.case, args.quiet)?;
    let units = args.units.unwrap_or(case.units);
    let existing = if args.overwrite { Existing::Overwrite } else { Existing::Protect };
    let request = Request {
        from_m,
        to_m,
        frictions,
        operations,
        helix_side_force: !args.no_helix_friction,
        units: Some(units),
        output: Output { folder: args.output.clone(), existing },
        png: args.png,
        jobs: args.jobs,
        ..Request::new(&case)
    };
    let outcome = reach::run(&request, &Silent, &interrupt::listen())?;
    if args.quiet {
        return Ok(());
    }
    let (took_s, place) = (outcome.took.as_secs_f64(), outcome.folder.display());
    print_stdout(&format!(
        "{}Found in {took_s:.1} s\nResults in {place}\n",
        screen::text(&outcome.summary, units)
    ))
}

/// The values of an option; none where it is not given.
fn values(option: &str, text: Option<&str>, of: Dimension) -> Result<Vec<f64>, Failure> {
    let values = text.map(|text| read_values(option, text, of)).transpose();
    let values = values.map_err(|report| Failure::BadInput(report.render(color())))?;
    Ok(values.unwrap_or_default())
}

fn friction(text: &str) -> Result<f64, Failure> {
    text.parse().map_err(|_| {
        Failure::BadInput(format!("error: `{text}` is no friction factor: expected such as 0.3"))
    })
}

fn operation(name: &str) -> Result<OperationKind, Failure> {
    OperationKind::from_name(name).ok_or_else(|| {
        let names = OperationKind::ALL.map(OperationKind::name).join(", ");
        Failure::BadInput(format!("error: `{name}` is no operation: expected one of {names}"))
    })
}
