//! `wholestring modes`: natural frequencies, critical speeds and the response to a rotating force.

mod args;
mod screen;

use wholestring_runner::modes::{self, Request};

use crate::{
    conclusion::refuse_errors, failure::Failure, input::load, interrupt, progress::RunScreen,
    stopped::unless_interrupted, terminal::print_stdout,
};

pub(crate) use args::ModesArgs;

pub(crate) fn modes(args: &ModesArgs) -> Result<(), Failure> {
    let case = load(&args.case, args.page.quiet)?;
    let units = args.page.units.unwrap_or(case.units);
    let request = Request {
        case: &case,
        operation: args.operation.as_deref(),
        units: Some(units),
        output: args.output.output(),
        png: args.page.png,
        jobs: None,
    };
    let screen = RunScreen::new(args.page.quiet, false);
    let outcome = modes::run(&request, &screen, &interrupt::listen())?;
    if !args.page.quiet {
        print_stdout(&screen::text(&outcome.summary, units))?;
        let took_ms = 1e3 * outcome.took.as_secs_f64();
        let place = outcome.folder.display();
        print_stdout(&format!("Found in {took_ms:.0} ms\nResults in {place}\n"))?;
    }
    unless_interrupted(outcome.interrupted, &outcome.folder)?;
    let named = outcome.summary.checks.iter().map(|check| (String::new(), check));
    refuse_errors(args.page.strict, named)
}
