//! A kind of results, declared once: beside the command that leaves them.

use std::path::Path;

use wholestring_report::Plot;
use wholestring_results::{ResultsError, ResultsFolder};
use wholestring_units::UnitSet;

use crate::{
    error::Error,
    page::{FILE, write_picture},
};

/// Results of a command as their page and their pictures show them, made from the files that it
/// left.
pub(crate) trait Results: Sized {
    /// What a folder of them holds, in a message: `a plan`.
    const NOUN: &'static str;
    /// The table by which their folder is known, without its ending.
    const TABLE: &'static str;
    /// Pictures that are drawn unasked, by the names of their files without an ending.
    const PICTURES: &'static [&'static str];
    /// Whether the numbers of each of these lie beside it as CSV.
    const WITH_NUMBERS: bool = false;
    /// Files that are neither tables nor pictures nor the page.
    const FILES: &'static [&'static str] = &[];

    /// Everything that is reported, from the folder's files.
    fn gather(folder: &Path, units: Option<UnitSet>) -> Result<Self, ResultsError>;

    /// The page; none where there is nothing to show yet.
    fn html(&self) -> Option<String>;

    /// Every picture.
    fn plots(&self) -> Vec<Plot>;

    /// Writes page and pictures; those of earlier results that these have not go.
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

    /// Makes page and pictures again.
    fn write_again(folder: &ResultsFolder, units: Option<UnitSet>) -> Result<(), Error> {
        let found = Self::gather(folder.path(), units).map_err(Error::bad_input)?;
        Ok(found.write(folder, false)?)
    }
}

/// What two folders can be drawn together of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Overlay {
    /// Two of this kind are drawn on the same axes.
    Two,
    /// What a second one would show is varied in the first.
    Varied,
    /// Nothing.
    Nothing,
}

/// A kind of results, as whoever looks at a folder knows it.
pub(crate) struct ResultsKind {
    /// What a folder holds, in a message: `a plan`.
    pub(crate) noun: &'static str,
    /// Whether a folder holds them.
    pub(crate) is_in: fn(&Path) -> bool,
    /// Pictures that are drawn unasked, without their endings.
    pub(crate) pictures: &'static [&'static str],
    /// Whether the numbers of each lie beside it as CSV.
    pub(crate) with_numbers: bool,
    /// Files that are neither tables nor pictures nor the page.
    pub(crate) files: &'static [&'static str],
    /// What becomes of two folders that are to be drawn together.
    pub(crate) overlay: Overlay,
    /// Makes page and pictures again.
    pub(crate) write_again: fn(&ResultsFolder, Option<UnitSet>) -> Result<(), Error>,
    /// Every picture.
    pub(crate) plots: fn(&Path, Option<UnitSet>) -> Result<Vec<Plot>, Error>,
}

impl ResultsKind {
    /// As the results declare it.
    pub(crate) const fn of<R: Results>() -> Self {
        Self {
            noun: R::NOUN,
            is_in: |folder| folder.join(format!("{}.parquet", R::TABLE)).is_file(),
            pictures: R::PICTURES,
            with_numbers: R::WITH_NUMBERS,
            files: R::FILES,
            overlay: Overlay::Nothing,
            write_again: R::write_again,
            plots: |folder, units| Ok(R::gather(folder, units).map_err(Error::bad_input)?.plots()),
        }
    }

    /// Whether a command that leaves them wrote a file of that name, tables and page apart.
    pub(crate) fn has_file(&self, name: &str) -> bool {
        let is_picture = |(stem, ending): (&str, &str)| {
            let ours = matches!(ending, "svg" | "png") || ending == "csv" && self.with_numbers;
            ours && self.pictures.contains(&stem)
        };
        self.files.contains(&name) || name.rsplit_once('.').is_some_and(is_picture)
    }
}
