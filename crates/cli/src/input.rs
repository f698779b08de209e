//! Case files as a command names them.

use wholestring_case::{Case, Template};

use crate::{color::color, failure::Failure, shared_args::CaseArgs, terminal::print_stderr};

/// Reads the case with its overrides, and shows its warnings.
pub(crate) fn load(args: &CaseArgs, quiet: bool) -> Result<Case, Failure> {
    Ok(load_with_template(args, quiet)?.1)
}

/// The same, and the text that it was made of, from which other cases can be made.
pub(crate) fn load_with_template(
    args: &CaseArgs,
    quiet: bool,
) -> Result<(Template, Case), Failure> {
    let template = Template::read(&args.case)?;
    let case = template.case(&args.overrides)?;
    if !quiet && !case.warnings.is_empty() {
        print_stderr(&case.warnings.render(color()));
    }
    Ok((template, case))
}
