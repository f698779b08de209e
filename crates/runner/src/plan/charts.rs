//! Charts of `plan.xlsx`: curves against bit depth from the cells of its sheets.

use wholestring::{operation::OperationKind, well::FrictionLevel};
use wholestring_report::{
    Cells, FRICTION_STROKES, Sheet, WorkbookChart, WorkbookSeries, figure::Stroke,
    operation_colour, plan_friction_label, surface_limit_is_near, surface_limit_title,
};
use wholestring_results::{PlanMeasured, PlanOverlayRow, PlanSummary};

/// Names of the sheets with data of charts.
pub(super) const BROOMSTICK: &str = "Broomstick";
pub(super) const BUCKLING: &str = "Weight to buckle";
pub(super) const HYDRAULICS: &str = "Hydraulics";
pub(super) const MEASURED: &str = "Measured";
pub(super) const OVERLAY: &str = "Overlay";
pub(super) const SURFACE: &str = "Surface limits";

/// Headings of the columns of the charts.
const DEPTH: &str = "bit depth";
const OPERATION: &str = "operation";

/// All charts, of the first model if there are several.
pub(super) fn charts(summary: &PlanSummary, sheets: &[Sheet]) -> Vec<WorkbookChart> {
    let sheet = |name: &str| sheets.iter().find(|sheet| sheet.name == name);
    let mut charts = Vec::new();
    if let Some(points) = sheet(BROOMSTICK) {
        let broomstick = |title: &str, heading, is_shown: fn(OperationKind) -> bool| {
            let mut series = broomstick(summary, points, heading, is_shown);
            series.extend(
                sheet(MEASURED)
                    .map_or_else(Vec::new, |sheet| read(summary, sheet, heading, is_shown)),
            );
            series.extend(
                sheet(OVERLAY)
                    .map_or_else(Vec::new, |sheet| laid_over(summary, sheet, heading, is_shown)),
            );
            if !series.is_empty() {
                series.extend(
                    sheet(SURFACE)
                        .map_or_else(Vec::new, |sheet| borne(summary, sheet, heading, is_shown)),
                );
            }
            chart(title, heading, points, series)
        };
        charts.extend(broomstick("Hook load without block, off bottom", "hook load", |kind| {
            !kind.on_bottom()
        }));
        charts.extend(broomstick("Surface torque", "surface torque", OperationKind::rotates));
        charts.extend(broomstick(
            "Hook load without block, on bottom",
            "hook load",
            OperationKind::on_bottom,
        ));
    }
    if let Some(weights) = sheet(BUCKLING) {
        let series = buckling(summary, weights);
        charts.extend(chart("Weight on bit to buckle", "weight on bit", weights, series));
    }
    if let Some(mud) = sheet(HYDRAULICS) {
        let series = columns(mud, &[("standpipe", "standpipe pressure")]);
        charts.extend(chart("Standpipe pressure", "standpipe pressure", mud, series));
        let series = columns(mud, &DENSITIES);
        charts.extend(chart("Equivalent density at the bit", "equivalent density", mud, series));
    }
    charts
}

/// State of the mud, and the column of the density at the bit.
const DENSITIES: [(&str, &str); 5] = [
    ("circulating", "circulating bit"),
    ("running in, string closed", "surge closed bit"),
    ("running in, string open", "surge open bit"),
    ("pulling out, string closed", "swab closed bit"),
    ("pulling out, string open", "swab open bit"),
];

/// A chart of a quantity, in the unit of its first series, against depth; `None` without series.
fn chart(
    title: &str,
    quantity: &str,
    sheet: &Sheet,
    series: Vec<WorkbookSeries>,
) -> Option<WorkbookChart> {
    let first = series.first()?;
    Some(WorkbookChart {
        title: title.to_owned(),
        across: format!("{quantity}, {}", sheet.columns[first.across].unit),
        down: sheet.columns[first.down].head(),
        series,
    })
}

/// Operations of the plan that a chart shows.
fn shown(
    summary: &PlanSummary,
    is_shown: fn(OperationKind) -> bool,
) -> impl Iterator<Item = OperationKind> {
    summary.operations.iter().copied().filter(move |operation| is_shown(*operation))
}

/// A curve for each operation and friction level.
fn broomstick(
    summary: &PlanSummary,
    sheet: &Sheet,
    heading: &str,
    is_shown: fn(OperationKind) -> bool,
) -> Vec<WorkbookSeries> {
    let mut all = Vec::new();
    for operation in shown(summary, is_shown) {
        for (stroke, level) in FRICTION_STROKES.into_iter().zip(FrictionLevel::ALL) {
            let rows = rows(summary, sheet, operation, level);
            let title = format!("{} {}", operation.words(), plan_friction_label(summary, level));
            all.extend(series(sheet, title, heading, rows).map(|series| WorkbookSeries {
                colour: operation_colour(operation),
                stroke: Some(stroke),
                ..series
            }));
        }
    }
    all
}

/// Readings of each operation as points; the rows of a reading are consecutive.
fn read(
    summary: &PlanSummary,
    sheet: &Sheet,
    heading: &str,
    is_shown: fn(OperationKind) -> bool,
) -> Vec<WorkbookSeries> {
    let is_torque = heading == "surface torque";
    let column = if is_torque { "measured_N_m" } else { "hook_load_N" };
    let table = summary.measured_table();
    let place = |name: &str| table.columns().iter().position(|column| column.name == name);
    let Some((across, down)) = place(column).zip(place("bit_depth_m")) else { return Vec::new() };
    let mut all = Vec::new();
    for operation in shown(summary, is_shown) {
        let is_of = |measured: &PlanMeasured| {
            Some(&measured.model) == summary.models.first()
                && measured.operation == operation
                && measured.is_torque == is_torque
        };
        let Some(first) = summary.measured.iter().position(is_of) else { continue };
        let count = summary.measured[first..].iter().take_while(|measured| is_of(measured)).count();
        all.push(WorkbookSeries {
            name: format!("{} measured", operation.words()),
            sheet: sheet.name.clone(),
            across,
            down,
            rows: first..first + count,
            colour: operation_colour(operation),
            stroke: None,
        });
    }
    all
}

/// Results of another program for each operation; its rows are consecutive.
fn laid_over(
    summary: &PlanSummary,
    sheet: &Sheet,
    heading: &str,
    is_shown: fn(OperationKind) -> bool,
) -> Vec<WorkbookSeries> {
    let Some(overlay) = &summary.overlay else { return Vec::new() };
    let is_torque = heading == "surface torque";
    let column = if is_torque { "theirs_N_m" } else { "theirs_N" };
    let table = overlay.table();
    let place = |name: &str| table.columns().iter().position(|column| column.name == name);
    let Some((across, down)) = place(column).zip(place("bit_depth_m")) else { return Vec::new() };
    let mut all = Vec::new();
    for operation in shown(summary, is_shown) {
        let is_of = |row: &PlanOverlayRow| {
            Some(&row.model) == summary.models.first()
                && row.operation == operation
                && row.is_torque == is_torque
        };
        let Some(first) = overlay.rows.iter().position(is_of) else { continue };
        let count = overlay.rows[first..].iter().take_while(|row| is_of(row)).count();
        all.push(WorkbookSeries {
            name: format!("{} of another program", operation.words()),
            sheet: sheet.name.clone(),
            across,
            down,
            rows: first..first + count,
            colour: operation_colour(operation),
            stroke: Some(Stroke::LongDashed),
        });
    }
    all
}

/// A line for each limit close to the curves: two rows of its sheet, in their order.
fn borne(
    summary: &PlanSummary,
    sheet: &Sheet,
    heading: &str,
    is_shown: fn(OperationKind) -> bool,
) -> Vec<WorkbookSeries> {
    let is_torque = heading == "surface torque";
    let column = if is_torque { "allowed_N_m" } else { "allowed_N" };
    let table = summary.surface_limits_table();
    let place = |name: &str| table.columns().iter().position(|column| column.name == name);
    let Some((across, down)) = place(column).zip(place("bit_depth_m")) else { return Vec::new() };
    let points = summary
        .points
        .iter()
        .filter(|point| summary.models.first() == Some(&point.model) && is_shown(point.operation));
    let value = points.filter_map(|point| {
        let scalars = point.scalars?;
        Some(if is_torque { scalars.surface_torque_N_m } else { scalars.hook_load_N })
    });
    let largest = value.fold(0.0, |most: f64, value| most.max(value.abs()));
    let limits = summary.surface_limits.iter().enumerate();
    let near = limits
        .filter(|(_, limit)| limit.is_torque == is_torque && surface_limit_is_near(limit, largest));
    near.map(|(row, near)| WorkbookSeries {
        name: format!("limit: {}", surface_limit_title(near)),
        sheet: sheet.name.clone(),
        across,
        down,
        rows: 2 * row..2 * row + 2,
        // Operations of a broomstick do not use the last two colours.
        colour: 5 + row % 2,
        stroke: Some(Stroke::LongDashed),
    })
    .collect()
}

/// A curve for each operation that drills, each friction level and each buckling mode.
fn buckling(summary: &PlanSummary, sheet: &Sheet) -> Vec<WorkbookSeries> {
    let mut all = Vec::new();
    for operation in [OperationKind::Drill, OperationKind::Slide] {
        for (stroke, level) in FRICTION_STROKES.into_iter().zip(FrictionLevel::ALL) {
            for (shape, heading) in [("sinusoid", "sinusoidal weight"), ("helix", "helical weight")]
            {
                let rows = rows(summary, sheet, operation, level);
                let title = format!(
                    "{}, {shape} {}",
                    operation.words(),
                    plan_friction_label(summary, level)
                );
                // Two colours for each operation.
                let colour = 2 * usize::from(operation == OperationKind::Slide)
                    + usize::from(shape == "helix");
                all.extend(series(sheet, title, heading, rows).map(|series| WorkbookSeries {
                    colour,
                    stroke: Some(stroke),
                    ..series
                }));
            }
        }
    }
    all
}

/// A curve for each of some columns, over all rows.
fn columns(sheet: &Sheet, named: &[(&str, &str)]) -> Vec<WorkbookSeries> {
    let all = 0..sheet.columns.first().map_or(0, |column| column.cells.len());
    let numbered = named.iter().enumerate();
    numbered
        .filter_map(|(colour, (title, heading))| {
            let series = series(sheet, (*title).to_owned(), heading, all.clone())?;
            Some(WorkbookSeries { colour, ..series })
        })
        .collect()
}

/// A solid curve of a column over rows; `None` if there are no rows or no such column.
fn series(
    sheet: &Sheet,
    name: String,
    heading: &str,
    rows: std::ops::Range<usize>,
) -> Option<WorkbookSeries> {
    let place = |heading: &str| sheet.columns.iter().position(|column| column.heading == heading);
    let (across, down) = (place(heading)?, place(DEPTH)?);
    (!rows.is_empty()).then(|| WorkbookSeries {
        name,
        sheet: sheet.name.clone(),
        across,
        down,
        rows,
        colour: 0,
        stroke: Some(FRICTION_STROKES[1]),
    })
}

/// Rows of an operation with a friction level by the first model, which are consecutive.
fn rows(
    summary: &PlanSummary,
    sheet: &Sheet,
    operation: OperationKind,
    level: FrictionLevel,
) -> std::ops::Range<usize> {
    let words = |heading: &str| {
        let found = sheet.columns.iter().find(|column| column.heading == heading);
        match found.map(|column| &column.cells) {
            Some(Cells::Words(words)) => &words[..],
            _ => &[],
        }
    };
    let model = summary.models.first().map_or("", |model| model.name());
    let names = [("model", model), ("friction", level.name()), (OPERATION, operation.words())];
    let columns = names.map(|(heading, word)| (words(heading), word));
    let is_of = |row: &usize| {
        columns.iter().all(|(words, word)| words.get(*row).is_some_and(|found| found == word))
    };
    let count = columns[0].0.len();
    let first = (0..count).find(is_of).unwrap_or(count);
    first..first + (first..count).take_while(is_of).count()
}
