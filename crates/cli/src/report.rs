//! `wholestring report`: rebuilds the page of a results folder.

use std::path::PathBuf;

use clap::Args;
use wholestring_runner::write_report;
use wholestring_units::UnitSet;

use crate::{failure::Failure, terminal::print_stdout};

#[derive(Debug, Args)]
pub(crate) struct ReportArgs {
    /// Folder of results
    #[arg(value_name = "DIR")]
    pub(crate) folder: PathBuf,

    /// Units in which the page opens [default: the case's]
    #[arg(long, value_name = "si|metric|field")]
    pub(crate) units: Option<UnitSet>,
}

pub(crate) fn report(args: &ReportArgs) -> Result<(), Failure> {
    let page = write_report(&args.folder, args.units)?;
    print_stdout(&format!("{}\n", page.display()))
}
