//! Case files as a command names them.

use wholestring_case::{Case, Report, Template};

use crate::{color::color, failure::Failure, shared_args::CaseArgs, terminal::print_stderr};

/// Reads the case with its overrides, and shows its warnings.
pub(crate) fn load(args: &CaseArgs, quiet: bool) -> Result<Case, Failure> {
    Ok(load_with_template(args, quiet)?.1)
}

/// The same, and the text that it was made of.
pub(crate) fn load_with_template(
    args: &CaseArgs,
    quiet: bool,
) -> Result<(Template, Case), Failure> {
    let read = || {
        let template = Template::read(&args.case)?;
        let case = template.case(&args.overrides)?;
        Ok((template, case))
    };
    let (template, case) =
        read().map_err(|report: Report| Failure::BadInput(report.render(color())))?;
    if !quiet && !case.warnings.is_empty() {
        print_stderr(&case.warnings.render(color()));
    }
    Ok((template, case))
}
