//! `wholestring study`: solves the cases of a study, and writes its figures and tables.

use std::path::{Path, PathBuf};

use clap::Args;
use wholestring_case::Override;
use wholestring_runner::study::{self, CaseFiles, Request};

use crate::{
    color::color,
    conclusion::conclude_judged,
    failure::Failure,
    interrupt,
    progress::BatchScreen,
    shared_args::{BatchArgs, KeptArgs},
    terminal::print_stderr,
};

#[derive(Debug, Args)]
pub(crate) struct StudyArgs {
    /// Study file
    #[arg(value_name = "STUDY.toml")]
    pub(crate) study: PathBuf,

    /// Set a key of every case, such as `mesh.element_length=1.6m`; short keys: friction,
    /// bit_depth, rpm, wob. Repeatable
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub(crate) overrides: Vec<Override>,

    /// Also write PNG images, with 300 dots per inch
    #[arg(long)]
    pub(crate) png: bool,

    /// Exit with status 4 if a check of the results is an error
    #[arg(long)]
    pub(crate) strict: bool,

    #[command(flatten)]
    pub(crate) kept: KeptArgs,

    #[command(flatten)]
    pub(crate) batch: BatchArgs,
}

pub(crate) fn study(args: &StudyArgs) -> Result<(), Failure> {
    args.kept.check(&args.batch)?;
    let study = study::load(&args.study)?;
    let quiet = args.batch.quiet;
    if !quiet && !study.warnings.is_empty() {
        print_stderr(&study.warnings.render(color()));
    }
    let request = Request {
        study: &study,
        cases: CaseFiles::Beside(args.study.parent().unwrap_or(Path::new(""))),
        overrides: &args.overrides,
        keep: args.kept.keep(),
        png: args.png,
        batch: args.batch.options(),
    };
    let screen = BatchScreen::sweep("study", quiet);
    let outcome = study::run(&request, &screen, &interrupt::listen())?;
    conclude_judged(&outcome, "study", args.strict, quiet)
}
