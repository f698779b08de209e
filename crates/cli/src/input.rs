//! Case files as a command names them.

use std::path::Path;

use wholestring_case::{Case, Template};

use crate::{color::color, failure::Failure, shared_args::CaseArgs, terminal::print_stderr};

/// Reads the case with its overrides and prints its warnings.
pub(crate) fn load(args: &CaseArgs, quiet: bool) -> Result<Case, Failure> {
    Ok(load_with_template(args, quiet)?.1)
}

/// The text of a case, from a file or through a pipe.
pub(crate) fn read(path: &Path) -> Result<Template, Failure> {
    Ok(if is_pipe(path) { Template::read_pipe(path)? } else { Template::read(path)? })
}

/// Whether the path is a pipe, which can be read only once: `/dev/stdin`, `<(...)`.
pub(crate) fn is_pipe(path: &Path) -> bool {
    path.metadata().is_ok_and(|there| !there.is_file() && !there.is_dir())
}

/// The case of a template with the overrides; its warnings are printed.
pub(crate) fn case_of(template: &Template, args: &CaseArgs, quiet: bool) -> Result<Case, Failure> {
    let case = template.case(&args.overrides)?;
    if !quiet && !case.warnings.is_empty() {
        print_stderr(&case.warnings.render(color()));
    }
    Ok(case)
}

/// The same, with the template, from which other cases can be made.
pub(crate) fn load_with_template(
    args: &CaseArgs,
    quiet: bool,
) -> Result<(Template, Case), Failure> {
    let template = read(&args.case)?;
    let case = case_of(&template, args, quiet)?;
    Ok((template, case))
}
