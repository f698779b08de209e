//! Tables of a folder of results as a workbook, in display units: inputs, verdict and scalars
//! first.

use std::path::Path;

use serde_json::{Map, Value as Json};
use wholestring::outcome;
use wholestring_judge::Check;
use wholestring_report::{Cells, Sheet, SheetColumn, Workbook, input_tables, printed};
use wholestring_results::{Column, Data, Summary, TABLES, Table, read_any_summary};
use wholestring_units::{Dimension, UnitSet};

use crate::{
    error::Error,
    page::{PROGRAM, table},
    plan::page::workbook_of,
    results_kinds::kind_of,
    sheet::{inputs_of, line_sheet, lines, operation_words, sheet},
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

// The first sheets of a workbook of results: inputs, the verdict, and the scalars of the summary.

/// Entries of a summary that are not its scalars: they have sheets of their own, or mean nothing to
/// a reader.
const NOT_SCALARS: [&str; 9] = [
    "settings",
    "texts",
    "checks",
    "unchecked",
    "schema_version",
    "engine_version",
    "identity",
    // Of the inputs.
    "case",
    // A rate per length, for which the lines have no unit.
    "build_rate_rad_per_m",
];

/// Lists of a summary that no table has.
const LISTS: [&str; 1] = ["estimates"];

/// Inputs, verdict and scalars of a summary; sheets without rows are left out. The scalars of each
/// operation of a run are a table of their own.
fn first_sheets(summary: &Json, units: UnitSet) -> Vec<Sheet> {
    let tables = input_tables(&summary["settings"]);
    let rows: Vec<[String; 3]> = tables.iter().flat_map(|table| lines(table, units)).collect();
    let inputs = inputs_of("The inputs of the case with all defaults filled in", rows);
    let sheets = [inputs, verdict(summary, units), scalars(summary, units)];
    sheets.into_iter().filter(|sheet| !sheet.columns[0].cells.is_empty()).collect()
}

/// A check, and the solution that it belongs to.
struct Row {
    operation: String,
    model: String,
    friction: Option<f64>,
    check: Check,
}

/// Checks of the summary and of its operations, the most severe first.
fn rows(summary: &Json) -> Vec<Row> {
    let word = |key: &Json| key.as_str().unwrap_or_default().to_owned();
    // Earlier versions wrote `findings`.
    let listed = |of: &Json| {
        let checks = of["checks"].as_array().or_else(|| of["findings"].as_array());
        checks.cloned().unwrap_or_default()
    };
    let row = |whose: &Json, check: &Json| {
        Some(Row {
            operation: operation_words(&word(&whose["operation"])),
            model: word(&whose["model"]),
            friction: whose["friction"].as_f64(),
            check: serde_json::from_value(check.clone()).ok()?,
        })
    };
    let mut rows = Vec::new();
    for operation in summary["operations"].as_array().into_iter().flatten() {
        rows.extend(listed(operation).iter().filter_map(|check| row(operation, check)));
    }
    for check in &listed(summary) {
        // The checks of a reach have their own operation.
        let whose = if check["operation"].is_string() { check } else { summary };
        rows.extend(row(whose, check));
    }
    rows.sort_by_key(|row| std::cmp::Reverse(row.check.severity));
    rows
}

/// The checks of a summary, with severity and sentence.
fn verdict(summary: &Json, units: UnitSet) -> Sheet {
    let rows = rows(summary);
    let words = |heading: &str, meaning: &str, word: &dyn Fn(&Row) -> String| SheetColumn {
        heading: heading.to_owned(),
        unit: String::new(),
        meaning: meaning.to_owned(),
        cells: Cells::Words(rows.iter().map(word).collect()),
    };
    let length = Dimension::Length.unit_in(units);
    let number =
        |heading: &str, unit: &str, meaning: &str, number: &dyn Fn(&Row) -> Option<f64>| {
            SheetColumn {
                heading: heading.to_owned(),
                unit: unit.to_owned(),
                meaning: meaning.to_owned(),
                cells: Cells::Numbers(rows.iter().map(number).collect()),
            }
        };
    let mut columns = vec![
        words("severity", "How serious it is", &|row| row.check.severity.name().to_owned()),
        words("verdict", "The verdict in words", &|row| row.check.verdict.words().to_owned()),
        words("check", "What is compared or reported", &|row| row.check.kind.label().to_owned()),
        words("operation", "The operation", &|row| row.operation.clone()),
        words("model", "The model that found it", &|row| row.model.clone()),
        number("friction", "", "Friction factor of all sections", &|row| row.friction),
        words("sentence", "The check as a sentence", &|row| printed(&row.check.sentence_in(units))),
        words("component", "The component; empty for the rig", &|row| {
            row.check.component.clone().unwrap_or_default()
        }),
        number("measured depth", length.symbol, "Measured depth of the place", &|row| {
            Some(length.from_si(row.check.md_m?))
        }),
        number("factor", "", "Capacity over load", &|row| row.check.factor),
        number("required", "", "Required factor", &|row| row.check.required),
    ];
    // Columns that no check of these results has are left out.
    columns.retain(|column| match &column.cells {
        Cells::Words(words) => {
            column.heading == "severity" || words.iter().any(|it| !it.is_empty())
        }
        Cells::Numbers(numbers) => numbers.iter().any(Option::is_some),
    });
    Sheet {
        name: "Verdict".to_owned(),
        about: "The checks of the results, the most severe first".to_owned(),
        columns,
    }
}

/// Scalars of a summary: everything but settings, checks, and lists that tables have.
fn scalars(summary: &Json, units: UnitSet) -> Sheet {
    let entries = summary.as_object().into_iter().flatten();
    let entries = entries.filter(|(key, _)| !NOT_SCALARS.contains(&key.as_str()));
    let kept: Map<String, Json> = entries
        .filter_map(|(key, value)| Some((key.clone(), without_lists(key, value)?)))
        .collect();
    let tables = input_tables(&Json::Object(kept));
    let mut rows: Vec<[String; 3]> = tables.iter().flat_map(|table| lines(table, units)).collect();
    for row in &mut rows {
        if row[0] == "Case" {
            row[0] = "Results".to_owned();
        }
    }
    line_sheet(
        "Summary",
        "The scalars of the results",
        [
            ("part", "Part of the results"),
            ("quantity", "Name of the quantity, or of the item of a list"),
            ("value", "Its value, with its unit"),
        ],
        &rows,
    )
}

/// A value without the lists of tables in it; `None` where nothing is left.
fn without_lists(key: &str, value: &Json) -> Option<Json> {
    match value {
        Json::Null => None,
        Json::Array(items) if items.iter().any(|item| item.is_object() || item.is_array()) => {
            LISTS.contains(&key).then(|| value.clone())
        }
        Json::Array(items) if items.is_empty() => None,
        Json::Object(inner) => {
            let inner: Map<String, Json> = inner
                .iter()
                .filter_map(|(key, value)| Some((key.clone(), without_lists(key, value)?)))
                .collect();
            (!inner.is_empty()).then_some(Json::Object(inner))
        }
        Json::String(word) if key == "operation" => Some(Json::String(operation_words(word))),
        other => Some(other.clone()),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    /// A workbook begins with inputs, verdict and scalars; the checks of all operations are in one
    /// sheet, the most severe first, in words.
    #[test]
    fn the_verdict_is_before_the_tables() {
        let check = |severity: &str, kind: &str| {
            json!({
                "kind": kind, "severity": severity, "verdict": "OK", "component": null,
                "md_m": null, "to_md_m": null, "value": 1.0, "limit": 2.0, "factor": 2.0,
                "required": 1.1, "unit": "N·m", "sentence": "load 1 kN.m"
            })
        };
        let summary = json!({
            "settings": { "name": "A well" },
            "operations": [
                { "operation": "trip_out", "model": "soft", "checks": [check("ok", "make_up")] },
                { "operation": "drill", "model": "soft", "checks": [check("error", "make_up")] },
            ],
            "from_m": 1000.0,
        });
        let sheets = first_sheets(&summary, UnitSet::Si);
        let names: Vec<&str> = sheets.iter().map(|sheet| sheet.name.as_str()).collect();
        assert_eq!(names, ["Inputs", "Verdict", "Summary"]);
        let column = |heading: &str| {
            let column = sheets[1].columns.iter().find(|column| column.heading == heading);
            match &column.expect(heading).cells {
                Cells::Words(words) => words.clone(),
                Cells::Numbers(_) => panic!("{heading} has numbers"),
            }
        };
        assert_eq!(column("severity"), ["error", "ok"]);
        assert_eq!(column("operation"), ["drill", "trip out"]);
        assert_eq!(column("check")[0], wholestring_judge::CheckKind::MakeUp.label());
        let Cells::Words(values) = &sheets[2].columns[2].cells else { panic!("words") };
        assert_eq!(values[..], ["1000 m"]);
    }
}
