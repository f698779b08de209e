//! `wholestring study`: solves the cases of a study, and makes its figures and tables.

use std::path::Path;

use wholestring_runner::study::{self, Request};

use crate::{
    args::StudyArgs,
    color::color,
    conclusion::{conclude, judge},
    failure::Failure,
    interrupt,
    progress::BatchScreen,
    terminal::print_stderr,
};

pub(crate) fn study(args: &StudyArgs) -> Result<(), Failure> {
    args.kept.check(&args.batch)?;
    let study = study::load(&args.study)?;
    let quiet = args.batch.quiet;
    if !quiet && !study.warnings.is_empty() {
        print_stderr(&study.warnings.render(color()));
    }
    let request = Request {
        study: &study,
        cases: args.study.parent().unwrap_or(Path::new("")),
        overrides: &args.overrides,
        keep: args.kept.keep(),
        png: args.png,
        batch: args.batch.options(),
    };
    let screen = BatchScreen::sweep("study", quiet);
    let outcome = study::run(&request, &screen, &interrupt::listen())?;
    conclude(&outcome, "study", "cases", quiet)?;
    judge(&outcome, args.strict, quiet)
}
