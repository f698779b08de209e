//! `report.html` of a sweep, made from the files in its folder.

use std::path::Path;

use wholestring_report::{Sweep, address, sweep_html, sweep_plots};
use wholestring_results::{ResultsError, ResultsFolder, Summary, Table};
use wholestring_units::UnitSet;

use super::{read::varied, table::FILE};
use crate::{
    page,
    results_kind::{Overlay, ResultsKind},
};

/// Results of a sweep.
pub(crate) const SWEEP: ResultsKind = ResultsKind {
    noun: "a sweep",
    is_in: |folder| folder.join(FILE).is_file(),
    pictures: &[],
    with_numbers: false,
    files: &[FILE],
    overlay: Overlay::Varied,
    // A sweep has none: its cases have.
    check_summary: |_| Ok(()),
    write_again: |folder, units| Ok(write(folder, units)?),
    plots: |folder, units| {
        let sweep = gather(folder, units)?;
        Ok(sweep_plots(&sweep, &sweep.head.units))
    },
};

/// Writes the page of the sweep in the folder; nothing if no case has ended yet.
pub(crate) fn write(folder: &ResultsFolder, units: Option<UnitSet>) -> Result<(), ResultsError> {
    let sweep = gather(folder.path(), units)?;
    if sweep.is_empty() {
        return folder.remove(page::FILE);
    }
    folder.write_file(page::FILE, sweep_html(&sweep).as_bytes())
}

/// Page data of a sweep.
fn gather(folder: &Path, units: Option<UnitSet>) -> Result<Sweep, ResultsError> {
    let path = folder.join(FILE);
    let table = Table::read_csv(&path)?;
    let varied = varied(&path, table.columns())?;
    // Cases that keep no page of their own have no link.
    let page = |case: &str| {
        let there = folder.join(case).join(page::FILE).is_file();
        there.then(|| format!("{}/{}", address(case), page::FILE))
    };
    let folders = table.words("folder").unwrap_or_default();
    let summary = |case: Option<&String>| {
        let path = case.map(|case| folder.join(case).join("summary.json"));
        path.filter(|path| path.is_file()).map(|path| Summary::read(&path)).transpose()
    };
    let (first, last) = (summary(folders.first())?, summary(folders.last())?);
    Sweep::new((&table, varied), [first.as_ref(), last.as_ref()], page, units, &path)
}
