//! `wholestring report` and `wholestring plot`: the page and the pictures of a results folder.

use std::path::PathBuf;

use clap::Args;
use wholestring_results::ResultsFolder;
use wholestring_runner::{pictures, pictures_folder, write_picture, write_report};
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

// `wholestring plot`: the plots of a run, of two runs on the same axes, of a sweep, or of a bit
// test, as files.

#[derive(Debug, Args)]
pub(crate) struct PlotArgs {
    /// Results folder, or those of two runs
    #[arg(value_name = "DIR", required = true, num_args = 1..=2)]
    pub(crate) folders: Vec<PathBuf>,

    /// Folder for the pictures [default: plots in the first DIR; of two, plots-SECOND]
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,

    /// Also write PNG images, with 300 dots per inch
    #[arg(long)]
    pub(crate) png: bool,

    /// Units on the axes [default: the case's]
    #[arg(long, value_name = "si|metric|field")]
    pub(crate) units: Option<UnitSet>,
}

pub(crate) fn plot(args: &PlotArgs) -> Result<(), Failure> {
    let plots = pictures(&args.folders, args.units)?;
    let output = args.output.clone();
    let output = output.unwrap_or_else(|| pictures_folder(&args.folders));
    let folder = ResultsFolder::create(output)?;
    for plot in &plots {
        write_picture(&folder, &plot.name, &plot.figure, args.png)?;
    }
    let place = folder.path().display();
    let pictures = if plots.len() == 1 { "picture" } else { "pictures" };
    print_stdout(&format!("{} {pictures} in {place}\n", plots.len()))
}
