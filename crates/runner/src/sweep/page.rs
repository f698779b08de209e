//! `report.html` of a sweep, made from the files in its folder.

use std::{collections::BTreeMap, path::Path};

use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_judge::Wording;
use wholestring_report::{PageHead, Sweep, SweepRow, address, in_sets, sweep_html, sweep_plots};
use wholestring_results::{Column, Data, ResultsError, ResultsFolder, Summary, Table};
use wholestring_units::UnitSet;

use super::{read::varied, table::FILE};
use crate::{
    page::{self, facts},
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
    write_again: |folder, units| Ok(write(folder, units)?),
    plots: |folder, units| {
        let sweep = gather(folder, units)?;
        Ok(sweep_plots(&sweep, &sweep.head.units))
    },
};

/// Writes the page of the sweep in the folder; nothing if no case has ended yet.
pub(crate) fn write(folder: &ResultsFolder, units: Option<UnitSet>) -> Result<(), ResultsError> {
    let sweep = gather(folder.path(), units)?;
    if sweep.rows.is_empty() {
        return folder.remove(page::FILE);
    }
    folder.write_file(page::FILE, sweep_html(&sweep).as_bytes())
}

/// The model or the operation of a name; `None` for a case that failed before it had any.
fn known<T>(
    folder: &Path,
    what: &str,
    name: &str,
    named: fn(&str) -> Option<T>,
) -> Result<Option<T>, ResultsError> {
    let found = named(name);
    match name.is_empty() || found.is_some() {
        true => Ok(found),
        false => Err(ResultsError::Format {
            path: folder.join(FILE),
            reason: format!("'{name}' is no {what}"),
        }),
    }
}

/// Page data of a sweep.
fn gather(folder: &Path, units: Option<UnitSet>) -> Result<Sweep, ResultsError> {
    let table = Table::read_csv(&folder.join(FILE))?;
    let columns = table.columns();
    let varied = varied(&folder.join(FILE), columns)?;
    let (varied, others) = columns.split_at(varied);
    let value = |column: &Column, row: usize| match &column.data {
        Data::Text(words) => words[row].clone(),
        Data::Number(_) => String::new(),
    };
    let word = |name: &str, row: usize| {
        let column = others.iter().find(|column| column.name == name);
        column.map_or_else(String::new, |column| value(column, row))
    };
    let numbers = |row: usize| -> BTreeMap<String, f64> {
        let number = |column: &Column| {
            let number = value(column, row).parse().ok()?;
            Some((column.name.clone(), number))
        };
        others.iter().filter_map(number).collect()
    };
    // Sweeps of versions without checks have no such columns.
    let count =
        |name: &str, row: usize| word(name, row).parse::<f64>().map_or(0, |many| many as usize);
    // Cases that keep no page of their own have no link.
    let page = |case: &str| {
        let there = !case.is_empty() && folder.join(case).join(page::FILE).is_file();
        there.then(|| format!("{}/{}", address(case), page::FILE))
    };
    let sentence = |row: usize| match word("worst_check_sentence", row) {
        // Column of earlier versions.
        sentence if sentence.is_empty() => word("worst_finding_message", row),
        sentence => sentence,
    };
    let rows = table.rows();
    let row = |row: usize| {
        let [model, operation] = ["model", "operation"].map(|name| word(name, row));
        Ok(SweepRow {
            values: varied.iter().map(|column| value(column, row)).collect(),
            model: known(folder, "model", &model, ModelKind::named)?,
            operation: known(folder, "operation", &operation, OperationKind::from_name)?,
            status: word("status", row),
            numbers: numbers(row),
            errors: count("errors", row),
            warnings: count("warnings", row),
            check: match serde_json::from_str::<Wording>(&word("worst_check_parts", row)) {
                Ok(wording) => in_sets(|units| wording.in_units(units)),
                Err(_) => [(); 3].map(|()| sentence(row)),
            },
            page: page(&word("folder", row)),
        })
    };
    let rows: Vec<SweepRow> = (0..rows).map(row).collect::<Result<_, ResultsError>>()?;
    let folders: Vec<String> = (0..rows.len()).map(|row| word("folder", row)).collect();
    let summary = |name: Option<&String>| {
        let path = name.map(|name| folder.join(name).join("summary.json"));
        let path = path.filter(|path| path.is_file());
        path.map(|path| Summary::read(&path)).transpose()
    };
    let first = summary(folders.first())?;
    // The last case differs from the first in every key that was varied.
    let last = summary(folders.last())?;
    let facts = |summary: &Option<Summary>| summary.as_ref().map_or(Vec::new(), facts::facts);
    let mut common = facts(&first);
    let others = facts(&last);
    common.retain(|fact| others.contains(fact));
    let settings = first.as_ref().map(|first| &first.settings);
    let title = first.as_ref().map_or_else(|| "Sweep".into(), |first| first.case.clone());
    Ok(Sweep {
        head: PageHead::new(title, units, settings, common),
        keys: varied.iter().map(|column| column.name.clone()).collect(),
        checked: table.columns().iter().any(|column| column.name == "errors"),
        rows,
    })
}
