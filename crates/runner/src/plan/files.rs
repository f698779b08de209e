//! The files of a plan.

use wholestring_results::{
    Column, Data, PlanMeasured, PlanOverlayRow, PlanPoint, PlanSummary, ResultsError,
    ResultsFolder, Table, UncertainBand, plan_peaks_table,
};

use super::levels::LEVELS;
use crate::uncertain::{self, Names};

/// Names of the tables, without their endings.
pub(super) const BROOMSTICK: &str = "plan_broomstick";
pub(super) const BUCKLING: &str = "plan_buckling";
pub(super) const FRICTION: &str = "plan_friction";
pub(super) const LIMITS: &str = "plan_limits";
pub(super) const SURFACE: &str = "plan_surface_limits";
pub(super) const HYDRAULICS: &str = "plan_hydraulics";
pub(super) const FATIGUE: &str = "plan_fatigue";
pub(super) const WEAR: &str = "plan_wear";
pub(super) const MEASURED: &str = "plan_measured";
pub(super) const OVERLAY: &str = "plan_overlay";
pub(super) const PEAKS: &str = "plan_peaks";
pub(super) const PEAKS_TIME: &str = "plan_peaks_time";

/// Tables whose rows the summary has not all of.
pub(super) struct Tables {
    /// Of limits.
    pub(super) limits: Table,
    /// Of fatigue.
    pub(super) fatigue: Table,
    /// Of casing wear.
    pub(super) wear: Table,
    /// Of the samples of what is uncertain, where anything is.
    pub(super) samples: Option<Table>,
    /// Of events against time.
    pub(super) peaks_time: Table,
}

/// Name of the workbook.
pub(super) const WORKBOOK: &str = "plan.xlsx";

/// Writes the summary and all tables, as CSV too: the page leads to them; and the numbers of each
/// picture.
pub(super) fn write(
    folder: &ResultsFolder,
    summary: &PlanSummary,
    tables: &Tables,
) -> Result<(), ResultsError> {
    folder.write_table(LIMITS, &tables.limits, true)?;
    folder.write_table(FATIGUE, &tables.fatigue, true)?;
    folder.write_table(WEAR, &tables.wear, true)?;
    let uncertain = summary.uncertain.as_ref().zip(tables.samples.as_ref());
    uncertain::write(folder, &Names::PLAN, uncertain)?;
    uncertain::write_picture_numbers(folder, summary.uncertain.as_ref())?;
    folder.write_table(BROOMSTICK, &summary.broomstick_table(), true)?;
    folder.write_table(BUCKLING, &summary.buckling_table(), true)?;
    folder.write_table(FRICTION, &summary.friction_table(), true)?;
    if summary.surface_limits.is_empty() {
        for ending in ["parquet", "csv"] {
            folder.remove(&format!("{SURFACE}.{ending}"))?;
        }
    } else {
        folder.write_table(SURFACE, &summary.surface_limits_table(), true)?;
    }
    if summary.peaks.is_empty() {
        for name in [PEAKS, PEAKS_TIME, "peaks"] {
            folder.remove(&format!("{name}.parquet"))?;
            folder.remove(&format!("{name}.csv"))?;
        }
    } else {
        folder.write_table(PEAKS, &plan_peaks_table(&summary.peaks), true)?;
        folder.write_table(PEAKS_TIME, &tables.peaks_time, true)?;
        tables.peaks_time.write_csv(&folder.path().join("peaks.csv"))?;
    }
    let picture = folder.path().join("hydraulics.csv");
    if summary.hydraulics.is_empty() {
        for name in ["plan_hydraulics.parquet", "plan_hydraulics.csv", "hydraulics.csv"] {
            folder.remove(name)?;
        }
    } else {
        let table = summary.hydraulics_table();
        folder.write_table(HYDRAULICS, &table, true)?;
        table.write_csv(&picture)?;
    }
    if summary.measured.is_empty() {
        for ending in ["parquet", "csv"] {
            folder.remove(&format!("{MEASURED}.{ending}"))?;
        }
    } else {
        folder.write_table(MEASURED, &summary.measured_table(), true)?;
    }
    match &summary.overlay {
        Some(overlay) => folder.write_table(OVERLAY, &overlay.table(), true)?,
        None => {
            for ending in ["parquet", "csv"] {
                folder.remove(&format!("{OVERLAY}.{ending}"))?;
            }
        }
    }
    for (name, table) in pictures(summary) {
        table.write_csv(&folder.path().join(format!("{name}.csv")))?;
    }
    summary.write(&folder.path().join("summary.json"))
}

/// Another program's curves below the rows of ours, a column for each operation.
fn theirs(summary: &PlanSummary, table: Table, quantity: &str, is_torque: bool) -> Table {
    let first = |of: &&PlanOverlayRow| {
        summary.models.first() == Some(&of.model) && of.is_torque == is_torque
    };
    let rows: Vec<&PlanOverlayRow> =
        summary.overlay.iter().flat_map(|of| &of.rows).filter(first).collect();
    if rows.is_empty() {
        return table;
    }
    let above = table.rows();
    let mut columns = table.columns().to_vec();
    for column in &mut columns {
        let is_depth = column.name == "bit_depth_m";
        if let Data::Number(values) = &mut column.data {
            values.extend(rows.iter().map(|of| is_depth.then_some(of.bit_depth_m)));
        }
    }
    for operation in &summary.operations {
        let of_operation = |of: &&PlanOverlayRow| of.operation == *operation;
        if rows.iter().any(of_operation) {
            let mut values = vec![None; above];
            values.extend(rows.iter().map(|of| of_operation(of).then_some(of.theirs)));
            columns.push(Column::numbers(format!("{operation}_overlay_{quantity}"), values));
        }
    }
    Table::new(columns)
}

/// The limits of a picture beside its curves, a column for each: the same at every depth.
fn with_limits(summary: &PlanSummary, table: Table, quantity: &str, is_torque: bool) -> Table {
    let mut columns = table.columns().to_vec();
    for of in summary.surface_limits.iter().filter(|of| of.is_torque == is_torque) {
        let name = format!("{}_limit_{quantity}", of.kind);
        columns.push(Column::numbers(name, vec![Some(of.allowed); table.rows()]));
    }
    Table::new(columns)
}

/// What each picture shows, a column for each of its curves.
fn pictures(summary: &PlanSummary) -> [(&'static str, Table); 3] {
    // Below the rows of the curves, one for each reading.
    let first = |of: &&PlanMeasured| summary.models.first() == Some(&of.model);
    let read: Vec<&PlanMeasured> = summary.measured.iter().filter(first).collect();
    let depth = |read: &[&PlanMeasured]| {
        let depths =
            summary.bit_depths_m.iter().copied().chain(read.iter().map(|of| of.bit_depth_m));
        Column::numbers("bit_depth_m", depths.map(Some).collect())
    };
    let at = |depth_m: f64, found: Option<f64>| (depth_m, found);
    let column = |name: String, found: &[(f64, Option<f64>)]| {
        let value = |depth: &f64| found.iter().find(|(at, _)| at == depth)?.1;
        Column::numbers(name, summary.bit_depths_m.iter().map(value).collect())
    };
    let curves = |quantity: &str, is_torque: bool, of: fn(&PlanPoint) -> Option<f64>| {
        let mut columns = vec![depth(&[])];
        for model in &summary.models {
            for operation in &summary.operations {
                for friction in LEVELS {
                    let points = summary.curve(model, operation, friction);
                    let found: Vec<_> = points.map(|one| at(one.bit_depth_m, of(one))).collect();
                    let name = format!("{operation}_{friction}_{model}_{quantity}");
                    columns.push(column(name, &found));
                }
            }
        }
        let read: Vec<_> = read.iter().filter(|of| of.is_torque == is_torque).copied().collect();
        if read.is_empty() {
            return Table::new(columns);
        }
        columns[0] = depth(&read);
        for column in &mut columns[1..] {
            if let Data::Number(values) = &mut column.data {
                values.resize(values.len() + read.len(), None);
            }
        }
        for operation in &summary.operations {
            let mut values = vec![None; summary.bit_depths_m.len()];
            let of_operation = |of: &&PlanMeasured| of.operation == *operation;
            values.extend(read.iter().map(|of| of_operation(of).then(|| of.beside_curves())));
            columns.push(Column::numbers(format!("{operation}_measured_{quantity}"), values));
        }
        Table::new(columns)
    };
    let bands = |table: Table, quantity: &str| {
        let (unit, is_torque) = if quantity == "hook_load" { ("N", false) } else { ("N_m", true) };
        let table = with_limits(summary, table, &format!("{quantity}_{unit}"), is_torque);
        let mut columns = table.columns().to_vec();
        let rows = table.rows();
        let uncertain = summary.uncertain.iter();
        let of: Vec<&UncertainBand> = uncertain.flat_map(|of| &of.bands).collect();
        for operation in &summary.operations {
            let of = of.iter().filter(|of| of.quantity == quantity && of.operation == *operation);
            for (place, part) in [(0, "p05"), (2, "p50"), (4, "p95")] {
                let found =
                    of.clone().filter_map(|of| Some((of.bit_depth_m?, Some(of.quantiles[place]))));
                let found: Vec<_> = found.collect();
                if !found.is_empty() {
                    let mut band = column(format!("{operation}_{part}_{quantity}_{unit}"), &found);
                    // Readings stand below the rows of the curves.
                    if let Data::Number(values) = &mut band.data {
                        values.resize(rows, None);
                    }
                    columns.push(band);
                }
            }
        }
        Table::new(columns)
    };
    let mut weights = vec![depth(&[])];
    for operation in ["drill", "slide"] {
        for friction in LEVELS {
            let rows = summary.buckling.iter();
            let rows = rows.filter(|of| of.operation == operation && of.friction == friction);
            let rows: Vec<_> = rows.collect();
            for shape in ["sinusoidal", "helical"] {
                let found: Vec<_> = rows
                    .iter()
                    .map(|of| match shape {
                        "sinusoidal" => at(of.bit_depth_m, of.sinusoidal_weight_N),
                        _ => at(of.bit_depth_m, of.helical_weight_N),
                    })
                    .collect();
                weights.push(column(format!("{operation}_{friction}_{shape}_weight_N"), &found));
            }
        }
    }
    [
        (
            "hook_load",
            bands(
                theirs(
                    summary,
                    curves("hook_load_N", false, |of| Some(of.scalars?.hook_load_N)),
                    "hook_load_N",
                    false,
                ),
                "hook_load",
            ),
        ),
        (
            "torque",
            bands(
                theirs(
                    summary,
                    curves("surface_torque_N_m", true, |of| Some(of.scalars?.surface_torque_N_m)),
                    "surface_torque_N_m",
                    true,
                ),
                "surface_torque",
            ),
        ),
        ("buckling_weight", Table::new(weights)),
    ]
}
