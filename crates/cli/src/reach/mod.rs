//! `wholestring reach`: greatest depth of the well, and the limit that stops it.

mod args;
mod screen;

use wholestring_case::read_values;
use wholestring_runner::reach::{self, Request};
use wholestring_units::Dimension;

use crate::{
    color::color,
    conclusion::{conclude, refuse_errors},
    failure::Failure,
    input::load_with_template,
    interrupt,
    progress::BatchScreen,
    shared_args::operation,
    stopped::unless_interrupted,
    terminal::print_stdout,
};

pub(crate) use args::ReachArgs;

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
    let (template, case) = load_with_template(&args.case, args.page.quiet)?;
    let units = args.page.units.unwrap_or(case.units);
    let request = Request {
        from_m,
        to_m,
        frictions,
        operations,
        helix_side_force: !args.no_helix_friction,
        stop_at_helix: args.stop_at_helix,
        units: Some(units),
        output: args.output(),
        png: args.page.png,
        jobs: args.jobs,
        ..Request::new(&case, &template, &args.case.overrides)
    };
    let outcome = reach::run(&request, &BatchScreen::reach(args.page.quiet), &interrupt::listen())?;
    if !args.page.quiet {
        print_stdout(&screen::text(&outcome.summary, units))?;
    }
    let checks = outcome.summary.checks.iter();
    let named = checks.map(|row| (row.operation.words().to_owned(), &row.check));
    let refused = || refuse_errors(args.page.strict, named);
    if let Some(samples) = &outcome.samples {
        conclude(samples, "reach", "samples", args.page.quiet)?;
        return refused();
    }
    if !args.page.quiet {
        let (took_s, place) = (outcome.took.as_secs_f64(), outcome.folder.display());
        print_stdout(&format!("Found in {took_s:.1} s\nResults in {place}\n"))?;
    }
    unless_interrupted(outcome.interrupted, &outcome.folder)?;
    refused()
}

/// The values of an option; empty if the option is missing.
fn values(option: &str, text: Option<&str>, dimension: Dimension) -> Result<Vec<f64>, Failure> {
    let values = text.map(|text| read_values(option, text, dimension)).transpose();
    let values = values.map_err(|report| Failure::BadInput(report.render(color())))?;
    Ok(values.unwrap_or_default())
}

fn friction(text: &str) -> Result<f64, Failure> {
    text.parse().map_err(|_| {
        Failure::BadInput(format!("error: `{text}` is no friction factor: expected such as 0.3"))
    })
}
