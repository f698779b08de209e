//! `wholestring bit-test`: the bit alone on its rock, at every weight and every speed.

mod args;
mod screen;

use wholestring_runner::bit_test::{self, Request};

use crate::{
    conclusion::{conclude, refuse_errors},
    failure::Failure,
    input::load,
    interrupt,
    progress::BatchScreen,
    terminal::print_stdout,
};

pub(crate) use args::BitTestArgs;

pub(crate) fn bit_test(args: &BitTestArgs) -> Result<(), Failure> {
    let quiet = args.batch.quiet;
    let case = load(&args.case, quiet)?;
    let units = args.units.unwrap_or(case.units);
    let request = Request { case: &case, units: Some(units), batch: args.batch.options() };
    let screen = BatchScreen::bit_test(quiet);
    let outcome = bit_test::run(&request, &screen, &interrupt::listen())?;
    if !quiet {
        print_stdout(&screen::text(&outcome.summary, units))?;
    }
    conclude(&outcome.batch, "bit test", "points", quiet)?;
    let named = outcome.summary.checks.iter().map(|check| (String::new(), check));
    refuse_errors(args.strict, named)
}
