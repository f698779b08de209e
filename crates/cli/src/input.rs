//! Case files as a command names them.

use wholestring_case::{Case, Template};

use crate::{args::CaseArgs, color::color, failure::Failure, terminal::print_stderr};

/// Reads the case with its overrides, and shows its warnings.
pub(crate) fn load(args: &CaseArgs, quiet: bool) -> Result<Case, Failure> {
    Ok(load_with_text(args, quiet)?.1)
}

/// The same with the text of the case, from which other cases can be made.
pub(crate) fn load_with_text(args: &CaseArgs, quiet: bool) -> Result<(Template, Case), Failure> {
    let template = Template::read(&args.case)?;
    let case = template.case(&args.overrides)?;
    if !quiet && !case.warnings.is_empty() {
        print_stderr(&case.warnings.render(color()));
    }
    Ok((template, case))
}
