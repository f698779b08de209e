//! `wholestring modes`: natural frequencies, critical speeds and the answer to a force that turns.

mod screen;

use wholestring_runner::{
    Existing, Output,
    modes::{self, Request},
};

use crate::{
    args::ModesArgs, failure::Failure, input::load, progress::RunScreen, terminal::print_stdout,
};

pub(crate) fn modes(args: &ModesArgs) -> Result<(), Failure> {
    let case = load(&args.case, args.quiet)?;
    let units = args.units.unwrap_or(case.units);
    let existing = if args.overwrite { Existing::Overwrite } else { Existing::Protect };
    let request = Request {
        case: &case,
        operation: args.operation.as_deref(),
        units: Some(units),
        output: Output { folder: args.output.clone(), existing },
        png: args.png,
    };
    let outcome = modes::run(&request, &RunScreen::new(args.quiet, false))?;
    if !args.quiet {
        print_stdout(&screen::text(&outcome.summary, units))?;
        let took_ms = 1e3 * outcome.took.as_secs_f64();
        let place = outcome.folder.display();
        print_stdout(&format!("Found in {took_ms:.0} ms\nResults in {place}\n"))?;
    }
    Ok(())
}
