//! Declaration of a kind of results, in the module of its command.

use std::path::Path;

use wholestring_report::Plot;
use wholestring_results::{ResultsError, ResultsFolder};
use wholestring_units::UnitSet;

use crate::{
    error::Error,
    page::{FILE, write_picture},
};

/// Results of a command in the form of their page and pictures, made from the files in its folder.
pub(crate) trait Results: Sized {
    /// Kind of results in messages: `a plan`.
    const NOUN: &'static str;
    /// Table that identifies a folder of these results, without its extension.
    const TABLE: &'static str;
    /// Pictures that are drawn by default, by the names of their files without extension.
    const PICTURES: &'static [&'static str];
    /// Whether the numbers of each picture are written next to it as CSV.
    const WITH_NUMBERS: bool = false;
    /// Files other than tables, pictures and the page.
    const FILES: &'static [&'static str] = &[];

    /// Reads the summary for its errors alone: those of its layout and version.
    fn check_summary(path: &Path) -> Result<(), ResultsError>;

    /// Reads all page data from the folder's files.
    fn gather(folder: &Path, units: Option<UnitSet>) -> Result<Self, ResultsError>;

    /// The page; `None` if there is nothing to show yet.
    fn html(&self) -> Option<String>;

    /// Every picture.
    fn plots(&self) -> Vec<Plot>;

    /// Writes page and pictures; removes earlier ones that these results do not have.
    fn write(&self, folder: &ResultsFolder, png: bool) -> Result<(), ResultsError> {
        let plots = self.plots();
        for name in Self::PICTURES {
            match plots.iter().find(|plot| plot.name == *name) {
                Some(plot) => write_picture(folder, name, &plot.figure, png)?,
                None => ["svg", "png"]
                    .iter()
                    .try_for_each(|ending| folder.remove(&format!("{name}.{ending}")))?,
            }
        }
        match self.html() {
            Some(html) => folder.write_file(FILE, html.as_bytes()),
            None => folder.remove(FILE),
        }
    }

    /// Rewrites page and pictures.
    fn write_again(folder: &ResultsFolder, units: Option<UnitSet>) -> Result<(), Error> {
        Ok(Self::gather(folder.path(), units)?.write(folder, false)?)
    }
}

/// Way in which two folders are drawn together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Overlay {
    /// Two of this kind are drawn on the same axes.
    Two,
    /// Values that a second folder would add can be varied in the first.
    Varied,
    /// Not possible.
    Nothing,
}

/// A kind of results, for code that inspects folders.
pub(crate) struct ResultsKind {
    /// Kind of results in messages: `a plan`.
    pub(crate) noun: &'static str,
    /// Whether a folder contains them.
    pub(crate) is_in: fn(&Path) -> bool,
    /// Pictures that are drawn by default, without extensions.
    pub(crate) pictures: &'static [&'static str],
    /// Whether the numbers of each picture are written next to it as CSV.
    pub(crate) with_numbers: bool,
    /// Files other than tables, pictures and the page.
    pub(crate) files: &'static [&'static str],
    /// Way in which two folders are drawn together.
    pub(crate) overlay: Overlay,
    /// Reads a summary for its errors alone: those of its layout and version.
    pub(crate) check_summary: fn(&Path) -> Result<(), ResultsError>,
    /// Rewrites page and pictures.
    pub(crate) write_again: fn(&ResultsFolder, Option<UnitSet>) -> Result<(), Error>,
    /// Every picture.
    pub(crate) plots: fn(&Path, Option<UnitSet>) -> Result<Vec<Plot>, Error>,
}

impl ResultsKind {
    /// The kind declared by the results.
    pub(crate) const fn of<R: Results>() -> Self {
        Self {
            noun: R::NOUN,
            is_in: |folder| folder.join(format!("{}.parquet", R::TABLE)).is_file(),
            pictures: R::PICTURES,
            with_numbers: R::WITH_NUMBERS,
            files: R::FILES,
            overlay: Overlay::Nothing,
            check_summary: R::check_summary,
            write_again: R::write_again,
            plots: |folder, units| Ok(R::gather(folder, units)?.plots()),
        }
    }

    /// Whether a command writes a file of that name for these results, other than tables and page.
    pub(crate) fn has_file(&self, name: &str) -> bool {
        let is_picture = |(stem, ending): (&str, &str)| {
            let ours = matches!(ending, "svg" | "png") || ending == "csv" && self.with_numbers;
            ours && self.pictures.contains(&stem)
        };
        self.files.contains(&name) || name.rsplit_once('.').is_some_and(is_picture)
    }
}
