//! Tables of a folder of results as a workbook, in display units.

use std::path::Path;

use wholestring::outcome;
use wholestring_report::Workbook;
use wholestring_results::{Column, Data, Summary, TABLES, Table, read_any_summary};
use wholestring_units::UnitSet;

use super::first_sheets::first_sheets;
use crate::{
    error::Error,
    page::{PROGRAM, table},
    plan::page::workbook_of,
    results_kinds::kind_of,
    sheet::sheet,
    sweep,
};

/// Table of a run that exceeds the size of a sheet: string positions, sample by sample.
const LEFT_OUT: &str = "frames";

/// Every table of the folder as a sheet.
pub(super) fn of_folder(
    folder: &Path,
    units: UnitSet,
    notes: &mut Vec<String>,
) -> Result<Workbook, Error> {
    let kind = kind_of(folder)?;
    let mut first = Vec::new();
    let mut sheets = Vec::new();
    match kind.noun {
        "a plan" => return Ok(workbook_of(folder, units)?),
        "a sweep" => {
            let (_, table) = sweep::read(folder)?;
            let about = "A row for each case, model and operation";
            sheets.push(sheet("Sweep", &table, about, units));
        }
        noun => {
            let path = folder.join("summary.json");
            first = first_sheets(&read_any_summary(&path)?, units);
            if noun == "a run" {
                let summary = Summary::read(&path)?;
                let about = "A row for each model and operation";
                first.push(sheet("Operations", &operations(&summary), about, units));
            }
        }
    }
    let mut tables = Vec::new();
    for (name, _) in TABLES.iter().filter(|(name, _)| *name != LEFT_OUT) {
        let table = table(folder, name)?;
        if table.rows() > 0 {
            tables.push((name, table));
        }
    }
    // Long tables last.
    tables.sort_by_key(|(_, table)| table.rows());
    let about = "As in the results";
    sheets.extend(tables.iter().map(|(name, table)| sheet(name, table, about, units)));
    if folder.join(format!("{LEFT_OUT}.parquet")).is_file() {
        notes.push(format!("{LEFT_OUT}.parquet is left out: no sheet is large enough for it"));
    }
    if sheets.is_empty() && first.is_empty() {
        return Err(Error::bad_input(format!("nothing was solved in {}", folder.display())));
    }
    Ok(Workbook {
        title: kind.noun.to_owned(),
        about: vec![format!("Made by {PROGRAM}. Units are those of the headings.")],
        first,
        charts: Vec::new(),
        sheets,
        printed_rows: None,
    })
}

/// The scalars of a run.
fn operations(summary: &Summary) -> Table {
    let all = &summary.operations;
    let words = |name: &str, values: Vec<String>| Column::words(name, values);
    let mut columns = vec![
        words("model", all.iter().map(|answer| answer.model.name().to_owned()).collect()),
        words("operation", all.iter().map(|answer| answer.operation.name().to_owned()).collect()),
        Column {
            name: "bit_depth_m".to_owned(),
            unit: "m".to_owned(),
            meaning: "Measured depth of the bit".to_owned(),
            data: Data::Number(all.iter().map(|answer| Some(answer.bit_depth_m)).collect()),
        },
    ];
    columns.extend(outcome::scalars_by_row().into_iter().map(|scalar| Column {
        name: scalar.quantity.name.to_owned(),
        unit: scalar.quantity.unit.to_owned(),
        meaning: scalar.quantity.meaning.to_owned(),
        data: Data::Number(all.iter().map(|answer| (scalar.of)(&answer.scalars)).collect()),
    }));
    Table::new(columns)
}
