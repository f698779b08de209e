//! Arguments of `wholestring modes`.

use clap::Args;
use wholestring::operation::OperationKind;
use wholestring_runner::job::{Job, Work, operation};

use crate::shared_args::{CaseArgs, OutputArgs, PageArgs};

#[derive(Debug, Args)]
// Not a doc comment, which would read `<case name>` as HTML.
#[command(mut_arg("output", |arg| {
    arg.help("Folder for the results [default: out/<case name> modes]")
}))]
pub(crate) struct ModesArgs {
    #[command(flatten)]
    pub(crate) case: CaseArgs,

    /// Operation whose static equilibrium the vibration is about, such as `drill` [default: the
    /// case's first]
    #[arg(long, value_name = "OPERATION", value_parser = operation)]
    pub(crate) operation: Option<OperationKind>,

    #[command(flatten)]
    pub(crate) output: OutputArgs,

    #[command(flatten)]
    pub(crate) page: PageArgs,
}

impl ModesArgs {
    /// The job of these arguments.
    pub(crate) fn job(&self) -> Job {
        let work = Work::Modes { operation: self.operation, png: self.page.png };
        Job { output: self.output.output(), units: self.page.units, ..self.case.job(work) }
    }
}
