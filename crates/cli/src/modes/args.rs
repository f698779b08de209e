//! Arguments of `wholestring modes`.

use clap::Args;

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
    #[arg(long, value_name = "OPERATION")]
    pub(crate) operation: Option<String>,

    #[command(flatten)]
    pub(crate) output: OutputArgs,

    #[command(flatten)]
    pub(crate) page: PageArgs,
}
