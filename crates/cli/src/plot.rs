//! `wholestring plot`: the pictures of a run, of two on the same axes, of a sweep, or of a bit
//! test, as files.

use wholestring_results::ResultsFolder;
use wholestring_runner::{pictures, pictures_folder, write_picture};

use crate::{args::PlotArgs, failure::Failure, terminal::print_stdout};

pub(crate) fn plot(args: &PlotArgs) -> Result<(), Failure> {
    let plots = pictures(&args.folders, args.units)?;
    let output = args.output.clone();
    let output = output.unwrap_or_else(|| pictures_folder(&args.folders));
    let folder = ResultsFolder::create(output)?;
    for plot in &plots {
        write_picture(&folder, &plot.name, &plot.figure, args.png)?;
    }
    let place = folder.path().display();
    print_stdout(&format!("{} pictures in {place}\n", plots.len()))
}
