//! Case files as a command names them.

use wholestring_case::Case;

use crate::{color::color, failure::Failure, shared_args::CaseArgs, terminal::print_stderr};

/// Reads the case with its overrides, and shows its warnings.
pub(crate) fn load(args: &CaseArgs, quiet: bool) -> Result<Case, Failure> {
    let case = wholestring_case::load(&args.case, &args.overrides)
        .map_err(|report| Failure::BadInput(report.render(color())))?;
    if !quiet && !case.warnings.is_empty() {
        print_stderr(&case.warnings.render(color()));
    }
    Ok(case)
}
