//! `wholestring plan`: torque and drag at every depth of the bit, with low, expected and high friction.

mod screen;

use wholestring_runner::{
    Output,
    plan::{self, Request},
};

use crate::{
    args::PlanArgs, conclusion::conclude, failure::Failure, input::load_with_text, interrupt,
    progress::BatchScreen, terminal::print_stdout,
};

pub(crate) fn plan(args: &PlanArgs) -> Result<(), Failure> {
    let (template, case) = load_with_text(&args.case, args.quiet)?;
    let units = args.units.unwrap_or(case.units);
    let request = Request {
        case: &case,
        template: &template,
        overrides: &args.case.overrides,
        units: Some(units),
        output: Output { folder: args.output.clone(), existing: args.existing() },
        jobs: args.jobs,
        checkpoint_every: args.checkpoint,
        png: args.png,
    };
    let outcome = plan::run(&request, &BatchScreen::plan(args.quiet), &interrupt::listen())?;
    if !args.quiet {
        print_stdout(&screen::text(&outcome.summary, units))?;
    }
    conclude(&outcome.batch, "plan", "pieces", args.quiet)
}
