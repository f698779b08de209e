//! `wholestring plan`: torque and drag at every bit depth, with low, expected and high friction.

mod args;
mod screen;

use wholestring_runner::plan::{self, Overlay, Request};

use crate::{
    conclusion::{conclude, refuse_errors},
    failure::Failure,
    input::load_with_template,
    interrupt,
    progress::BatchScreen,
    terminal::print_stdout,
};

pub(crate) use args::PlanArgs;

pub(crate) fn plan(args: &PlanArgs) -> Result<(), Failure> {
    let (template, case) = load_with_template(&args.case, args.page.quiet)?;
    let units = args.page.units.unwrap_or(case.units);
    let request = Request {
        case: &case,
        template: &template,
        overrides: &args.case.overrides,
        units: Some(units),
        output: args.output(),
        jobs: args.jobs,
        checkpoint_every: args.checkpoint.every,
        overlay: args.overlay.as_deref().map(Overlay::read).transpose()?,
        png: args.page.png,
    };
    let outcome = plan::run(&request, &BatchScreen::plan(args.page.quiet), &interrupt::listen())?;
    if !args.page.quiet {
        print_stdout(&screen::text(&outcome.summary, units))?;
    }
    conclude(&outcome.batch, "plan", "tasks", args.page.quiet)?;
    let rows = outcome.summary.checks.iter();
    let named = rows.map(|row| (row.operation.words().to_owned(), &row.check));
    refuse_errors(args.page.strict, named)
}
