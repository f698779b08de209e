//! `wholestring report`: the page of what lies in a folder, made again.

use wholestring_runner::write_report;

use crate::{args::ReportArgs, failure::Failure, terminal::print_stdout};

pub(crate) fn report(args: &ReportArgs) -> Result<(), Failure> {
    let page = write_report(&args.folder, args.units)?;
    print_stdout(&format!("{}\n", page.display()))
}
