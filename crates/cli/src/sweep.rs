//! `wholestring sweep`: solves a case for all combinations of some values.

use wholestring_case::{Template, Variation};
use wholestring_runner::sweep::{self, Request};

use crate::{
    args::SweepArgs,
    conclusion::{conclude, judge},
    failure::Failure,
    interrupt,
    progress::BatchScreen,
};

pub(crate) fn sweep(args: &SweepArgs) -> Result<(), Failure> {
    args.kept.check(&args.batch)?;
    let variations = Variation::read_all(&args.vary)?;
    let template = Template::read(&args.case.case)?;
    let request = Request {
        template: &template,
        overrides: &args.case.overrides,
        variations: &variations,
        keep: args.kept.keep(),
        batch: args.batch.options(),
    };
    let quiet = args.batch.quiet;
    let screen = BatchScreen::sweep("sweep", quiet);
    let outcome = sweep::run(&request, &screen, &interrupt::listen())?;
    conclude(&outcome, "sweep", "cases", quiet)?;
    judge(&outcome, args.strict, quiet)
}
