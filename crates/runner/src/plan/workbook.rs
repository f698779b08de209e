//! `plan.xlsx`: every table as a sheet, and the broomsticks as charts.

use wholestring_report::{
    Cells, FRICTION_STROKES, Sheet, SheetColumn, Workbook, WorkbookChart, WorkbookSeries,
    operation_name,
};
use wholestring_results::{Column, Data, PlanMeasured, PlanSummary, Table, plan_peaks_table};
use wholestring_units::UnitSet;

use super::{
    files::Tables,
    levels::{LEVELS, label},
};
use crate::page::{
    PROGRAM,
    dimensions::{of_setting, pretty, unit},
};

/// Name of the sheet of points.
const BROOMSTICK: &str = "Broomstick";

/// Name of the sheet of readings.
const MEASURED: &str = "Measured";

/// The workbook of a plan in these units.
pub(super) fn workbook(summary: &PlanSummary, found: &Tables, units: UnitSet) -> Workbook {
    let (points, measured) = (summary.broomstick_table(), summary.measured_table());
    let peaks = plan_peaks_table(&summary.peaks);
    let tables = [
        (
            BROOMSTICK,
            &points,
            "A row for each depth of the bit of each model, operation and friction",
        ),
        (
            "Weight to buckle",
            &summary.buckling_table(),
            "Weights on bit under which the string buckles",
        ),
        ("Limits", &found.limits, "Loads against what bears them, in the unit of each row"),
        ("Fatigue", &found.fatigue, "What the campaign takes of the string's life"),
        ("Casing wear", &found.wear, "What the campaign takes of the casing"),
        ("Peaks", &peaks, "What a string that sets itself in motion comes to, by the dynamics"),
        ("Peaks against time", &found.peaks_time, "The same, sample by sample"),
        ("Friction", &summary.friction_table(), "Friction of each hole section at each level"),
        (
            "Hydraulics",
            &summary.hydraulics_table(),
            "Pressures and equivalent densities with the bit at each depth",
        ),
        (
            MEASURED,
            &measured,
            "What was read, beside what the string in the hole is predicted to show",
        ),
    ];
    let is_there = |name: &str| match name {
        "Hydraulics" => !summary.hydraulics.is_empty(),
        "Peaks" | "Peaks against time" => !summary.peaks.is_empty(),
        MEASURED => !summary.measured.is_empty(),
        _ => true,
    };
    let tables = tables.into_iter().filter(|(name, ..)| is_there(name));
    let uncertain = summary.uncertain.as_ref();
    let scattered = uncertain.map(|of| (of.table(), of.indices_table()));
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
    let charts = [
        ("Hook load without block", "hook_load_N", "off bottom", false),
        ("Surface torque", "surface_torque_N_m", "all that turns", true),
    ];
    let charts = charts.into_iter().filter_map(|(title, column, which, turns)| {
        let mut chart = chart(summary, &sheets[0], &points, (title, column, which, turns))?;
        let read = if turns { "measured_N_m" } else { "hook_load_N" };
        chart.series.extend(read_points(summary, &measured, read, turns));
        Some(chart)
    });
    Workbook {
        title: format!("{}: plan", summary.case),
        about: vec![format!("Made by {PROGRAM}. Units are those of the headings.")],
        charts: charts.collect(),
        sheets,
    }
}

fn sheet(name: &str, table: &Table, about: &str, units: UnitSet) -> Sheet {
    let columns = table.columns().iter().map(|of| column(of, units)).collect();
    Sheet { name: name.to_owned(), about: about.to_owned(), columns }
}

/// A column in the reader's units, which stand in its heading.
fn column(of: &Column, units: UnitSet) -> SheetColumn {
    let found = of_setting(&of.name).filter(|_| !of.unit.is_empty());
    let (dimension, stem) = found.unwrap_or(("", &of.name));
    let shown = unit(dimension, units);
    let factor = shown.as_ref().map_or(1.0, |of| of.factor);
    let cells = match &of.data {
        Data::Number(values) => {
            Cells::Numbers(values.iter().map(|value| value.map(|value| value / factor)).collect())
        }
        Data::Text(words) => Cells::Words(words.iter().map(|word| readable(of, word)).collect()),
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

/// A curve for each operation and friction of the first model, from rows that stand together.
fn chart(
    summary: &PlanSummary,
    sheet: &Sheet,
    points: &Table,
    (title, quantity, which, turns): (&str, &str, &str, bool),
) -> Option<WorkbookChart> {
    let place = |name: &str| points.columns().iter().position(|of| of.name == name);
    let (across, down) = (place(quantity)?, place("bit_depth_m")?);
    let model = summary.models.first()?;
    let mut series = Vec::new();
    for (colour, operation) in summary.operations.iter().enumerate() {
        let kind = wholestring::operation::OperationKind::from_name(operation)?;
        let is_shown = if turns { kind.rotates() } else { !kind.on_bottom() };
        if !is_shown {
            continue;
        }
        for (stroke, friction) in FRICTION_STROKES.into_iter().zip(LEVELS) {
            let is_of = |of: &wholestring_results::PlanPoint| {
                of.model == *model && of.operation == *operation && of.friction == friction
            };
            let first = summary.points.iter().position(is_of)?;
            let rows = first..first + summary.curve(model, operation, friction).count();
            series.push(WorkbookSeries {
                name: format!("{} {}", operation_name(operation), label(summary, friction)),
                sheet: sheet.name.clone(),
                across,
                down,
                rows,
                colour,
                stroke: Some(stroke),
            });
        }
    }
    (!series.is_empty()).then(|| WorkbookChart {
        title: format!("{title}, {which}"),
        across: sheet.columns[across].head(),
        down: sheet.columns[down].head(),
        series,
    })
}

/// What was read in each operation, as points: rows of a reading stand together.
fn read_points(
    summary: &PlanSummary,
    measured: &Table,
    column: &str,
    torques: bool,
) -> Vec<WorkbookSeries> {
    let place = |name: &str| measured.columns().iter().position(|of| of.name == name);
    let Some((across, down)) = place(column).zip(place("bit_depth_m")) else { return Vec::new() };
    let mut all = Vec::new();
    for (colour, operation) in summary.operations.iter().enumerate() {
        let is_of = |of: &PlanMeasured| {
            Some(&of.model) == summary.models.first()
                && of.operation == *operation
                && of.is_torque == torques
        };
        let Some(first) = summary.measured.iter().position(is_of) else { continue };
        let count = summary.measured[first..].iter().take_while(|of| is_of(of)).count();
        all.push(WorkbookSeries {
            name: format!("{} measured", operation_name(operation)),
            sheet: MEASURED.to_owned(),
            across,
            down,
            rows: first..first + count,
            colour,
            stroke: None,
        });
    }
    all
}
