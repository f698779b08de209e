//! `wholestring sweep`: solves a case for all combinations of some values.

use std::sync::Arc;

use clap::Args;
use wholestring_case::Variation;
use wholestring_runner::sweep::{self, Request};

use crate::{
    conclusion::conclude_judged,
    failure::Failure,
    input::read,
    interrupt,
    progress::BatchScreen,
    shared_args::{BatchArgs, CaseArgs, KeptArgs},
};

#[derive(Debug, Args)]
pub(crate) struct SweepArgs {
    #[command(flatten)]
    pub(crate) case: CaseArgs,

    /// Values of a key, such as `friction=0.1,0.2,0.3` or `bit_depth=300m..4305m/300m` (a range
    /// always includes its end). Repeatable: every combination is a case, the last key varying
    /// fastest
    #[arg(long, value_name = "KEY=VALUES", required = true)]
    pub(crate) vary: Vec<String>,

    /// Exit with status 4 if a check of the results is an error
    #[arg(long)]
    pub(crate) strict: bool,

    #[command(flatten)]
    pub(crate) kept: KeptArgs,

    #[command(flatten)]
    pub(crate) batch: BatchArgs,
}

pub(crate) fn sweep(args: &SweepArgs) -> Result<(), Failure> {
    args.kept.check(&args.batch)?;
    let variations = Variation::read_all(&args.vary)?;
    let template = Arc::new(read(&args.case.case)?);
    let request = Request {
        template: &template,
        overrides: &args.case.overrides,
        variations: &variations,
        together: false,
        keep: args.kept.keep(),
        batch: args.batch.options(),
    };
    let quiet = args.batch.quiet;
    let screen = BatchScreen::sweep("sweep", quiet);
    let outcome = sweep::run(&request, &screen, &interrupt::listen())?;
    conclude_judged(&outcome, "sweep", args.strict, quiet)
}
