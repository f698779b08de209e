//! `wholestring run`: solves a case, prints one table and writes the results.

mod args;
mod convergence;

use crate::{
    failure::Failure,
    work::{carry_out, end, prepare, solve},
};

pub(crate) use args::RunArgs;

pub(crate) fn run(args: &RunArgs) -> Result<(), Failure> {
    let (job, screen) = (args.job(), args.screen());
    if !args.converge {
        return carry_out(&job, screen);
    }
    let prepared = prepare(&job, screen.quiet)?;
    convergence::check(&prepared)?;
    let base = solve(&job, &prepared, screen)?;
    convergence::halve(&job, &prepared, &base, screen)?;
    end(&job, base, screen)
}
