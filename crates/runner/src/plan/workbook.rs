//! `plan.xlsx`: every table as a sheet, and the broomsticks as charts.

use wholestring_report::{Cells, DisplayUnit, Sheet, SheetColumn, Workbook, operation_name};
use wholestring_results::{Column, Data, PlanSummary, Table, plan_peaks_table};
use wholestring_units::UnitSet;

use super::{
    charts::{BROOMSTICK, BUCKLING, HYDRAULICS, MEASURED, OVERLAY, charts},
    files::Tables,
};
use crate::page::{
    PROGRAM,
    dimensions::{of_setting, pretty, unit},
};

/// The workbook of a plan in these units.
pub(super) fn workbook(summary: &PlanSummary, found: &Tables, units: UnitSet) -> Workbook {
    let scattered = summary.uncertain.as_ref().map(|of| (of.table(), of.indices_table()));
    let measured = summary.measured_table();
    let overlay = summary.overlay.as_ref().map_or_else(|| Table::new(Vec::new()), |of| of.table());
    let peaks = plan_peaks_table(&summary.peaks);
    let tables = [
        (
            BROOMSTICK,
            &summary.broomstick_table(),
            "A row for each depth of the bit of each model, operation and friction",
        ),
        (BUCKLING, &summary.buckling_table(), "Weights on bit under which the string buckles"),
        ("Limits", &found.limits, "Loads against what bears them, in the unit of the row"),
        ("Fatigue", &found.fatigue, "What the campaign takes of the string's life"),
        ("Casing wear", &found.wear, "What the campaign takes of the casing"),
        ("Peaks", &peaks, "What a string that sets itself in motion comes to, by the dynamics"),
        ("Peaks against time", &found.peaks_time, "The same, sample by sample"),
        ("Friction", &summary.friction_table(), "Friction of each hole section at each level"),
        (
            HYDRAULICS,
            &summary.hydraulics_table(),
            "Pressures and equivalent densities with the bit at each depth",
        ),
        (
            MEASURED,
            &measured,
            "What was read, beside what the string in the hole is predicted to show",
        ),
        (OVERLAY, &overlay, "What another program computed, beside ours with expected friction"),
    ];
    let is_there = |name: &str| match name {
        HYDRAULICS => !summary.hydraulics.is_empty(),
        "Peaks" | "Peaks against time" => !summary.peaks.is_empty(),
        MEASURED => !summary.measured.is_empty(),
        OVERLAY => summary.overlay.is_some(),
        _ => true,
    };
    let tables = tables.into_iter().filter(|(name, ..)| is_there(name));
    let scattered = scattered.iter().flat_map(|(bands, indices)| {
        let samples = found.samples.as_ref();
        let samples =
            samples.map(|table| ("Samples", table, "What was drawn of each uncertain number"));
        [
            (
                "Uncertain",
                bands,
                "How the samples of uncertain numbers scatter, in the unit of each row",
            ),
            ("Owed to", indices, "Sobol indices: which uncertain numbers that is owed to"),
        ]
        .into_iter()
        .chain(samples)
    });
    let sheets: Vec<Sheet> = tables
        .chain(scattered)
        .map(|(name, table, about)| sheet(name, table, about, units))
        .collect();
    let charts = charts(summary, &sheets);
    Workbook {
        title: format!("{}: plan", summary.case),
        about: vec![format!("Made by {PROGRAM}. Units are those of the headings.")],
        charts,
        sheets,
    }
}

fn sheet(name: &str, table: &Table, about: &str, units: UnitSet) -> Sheet {
    let rows = row_units(table, units);
    let columns = table.columns().iter().map(|of| column(of, rows.as_deref(), units)).collect();
    Sheet { name: name.to_owned(), about: about.to_owned(), columns }
}

/// Columns whose unit is that of their row.
const OF_ROWS: [&str; 2] = ["load", "capacity"];

/// SI units that rows name, and what they are of.
const ROW_UNITS: [(&str, &str); 3] = [("N", "force"), ("N·m", "torque"), ("Pa", "pressure")];

/// The reader's unit of each row of a table whose rows name theirs.
fn row_units(table: &Table, units: UnitSet) -> Option<Vec<DisplayUnit>> {
    let shown = |si: &String| {
        let dimension = ROW_UNITS.iter().find(|(symbol, _)| symbol == si).map_or("", |of| of.1);
        unit(dimension, units).unwrap_or(DisplayUnit { symbol: si.clone(), factor: 1.0 })
    };
    Some(table.words("unit")?.iter().map(shown).collect())
}

/// What lies across a wall is as small as a diameter.
const ACROSS: [&str; 3] = ["groove_m", "wall_m", "wall_left_m"];

/// A column in the reader's units, which stand in its heading, or in the rows' own.
fn column(of: &Column, rows: Option<&[DisplayUnit]>, units: UnitSet) -> SheetColumn {
    let found = match of.name.strip_suffix("_m") {
        Some(stem) if ACROSS.contains(&of.name.as_str()) => Some(("diameter", stem)),
        _ => of_setting(&of.name),
    };
    let (dimension, stem) = found.filter(|_| !of.unit.is_empty()).unwrap_or(("", &of.name));
    let shown = unit(dimension, units);
    let all = shown.as_ref().map_or(1.0, |of| of.factor);
    let rows = rows.filter(|_| OF_ROWS.contains(&of.name.as_str()) || of.name == "unit");
    let factor = |row: usize| rows.and_then(|units| units.get(row)).map_or(all, |of| of.factor);
    let cells = match (&of.data, rows) {
        (Data::Number(values), _) => {
            let values = values.iter().enumerate();
            Cells::Numbers(values.map(|(row, value)| Some((*value)? / factor(row))).collect())
        }
        (Data::Text(_), Some(units)) => {
            Cells::Words(units.iter().map(|of| of.symbol.clone()).collect())
        }
        (Data::Text(words), None) => {
            Cells::Words(words.iter().map(|word| readable(of, word)).collect())
        }
    };
    SheetColumn {
        heading: stem.replace('_', " "),
        unit: shown.map_or_else(|| pretty(&of.unit), |of| of.symbol),
        meaning: of.meaning.replace('`', ""),
        cells,
    }
}

/// Operations as drillers call them; other words as they are.
fn readable(of: &Column, word: &str) -> String {
    match of.name.as_str() {
        "operation" => operation_name(word).to_owned(),
        "worst_finding" | "event" => word.replace('_', " "),
        _ => word.to_owned(),
    }
}
