//! `report.html` of a sweep, made from the files that it left.

use std::{collections::BTreeMap, path::Path};

use wholestring_report::{Sweep, SweepRow, sweep_html};
use wholestring_results::{ResultsError, ResultsFolder, Summary, Table};
use wholestring_units::UnitSet;

use super::table::FILE;
use crate::{
    column::words,
    report::{self, asked, dimensions},
};

/// Whether a folder is one that a sweep wrote to.
pub(crate) fn is_sweep(folder: &Path) -> bool {
    folder.join(FILE).is_file()
}

/// Writes the page of the sweep whose files are in the folder; nothing where no case has ended yet.
pub(crate) fn write(folder: &ResultsFolder, units: Option<UnitSet>) -> Result<(), ResultsError> {
    let sweep = gather(folder.path(), units)?;
    if sweep.rows.is_empty() {
        return folder.remove(report::FILE);
    }
    folder.write_file(report::FILE, sweep_html(&sweep).as_bytes())
}

/// Everything that is told of a sweep.
pub(crate) fn gather(folder: &Path, units: Option<UnitSet>) -> Result<Sweep, ResultsError> {
    let table = Table::read_csv(&folder.join(FILE))?;
    let names = table.columns().iter().map(|column| column.name.as_str());
    let keys: Vec<String> = names
        .clone()
        .take_while(|name| *name != "model")
        .map(String::from)
        .collect();
    let word = |name: &str, row: usize| words(&table, name).get(row).cloned().unwrap_or_default();
    let numbers = |row: usize| -> BTreeMap<String, f64> {
        names
            .clone()
            .skip(keys.len())
            .filter_map(|name| Some((name.to_owned(), word(name, row).parse().ok()?)))
            .collect()
    };
    let rows = table.rows();
    // Keys may be named like other columns: they are those that come first.
    let value = |key: usize, row: usize| match &table.columns()[key].data {
        wholestring_results::Data::Text(words) => words[row].clone(),
        wholestring_results::Data::Number(_) => String::new(),
    };
    let rows: Vec<SweepRow> = (0..rows)
        .map(|row| SweepRow {
            values: (0..keys.len()).map(|key| value(key, row)).collect(),
            model: word("model", row),
            operation: word("operation", row),
            status: word("status", row),
            numbers: numbers(row),
        })
        .collect();
    let folders = words(&table, "folder");
    let summary = |name: Option<&String>| {
        let path = name.map(|name| folder.join(name).join("summary.json"));
        let path = path.filter(|path| path.is_file());
        path.map(|path| Summary::read(&path)).transpose()
    };
    let first = summary(folders.first())?;
    // The last case differs from the first in every key that was varied.
    let last = summary(folders.last())?;
    let facts = |of: &Option<Summary>| of.as_ref().map_or(Vec::new(), asked::asked);
    let mut asked = facts(&first);
    let others = facts(&last);
    asked.retain(|fact| others.contains(fact));
    let settings = first.as_ref().map(|first| &first.settings);
    Ok(Sweep {
        program: report::PROGRAM.into(),
        title: first
            .as_ref()
            .map_or_else(|| "Sweep".into(), |first| first.case.clone()),
        units: match units {
            Some(units) => units.name().into(),
            None => settings
                .and_then(|settings| settings["units"].as_str())
                .unwrap_or("si")
                .into(),
        },
        dimensions: dimensions::all(),
        asked,
        keys,
        rows,
    })
}
