//! The files of a plan.

use wholestring_results::{
    Column, PlanPoint, PlanSummary, ResultsError, ResultsFolder, Table, plan_peaks_table,
};

/// Names of the tables, without their endings.
pub(super) const BROOMSTICK: &str = "plan_broomstick";
pub(super) const BUCKLING: &str = "plan_buckling";
pub(super) const FRICTION: &str = "plan_friction";
pub(super) const LIMITS: &str = "plan_limits";
pub(super) const HYDRAULICS: &str = "plan_hydraulics";
pub(super) const FATIGUE: &str = "plan_fatigue";
pub(super) const WEAR: &str = "plan_wear";
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
    folder.write_table(BROOMSTICK, &summary.broomstick_table(), true)?;
    folder.write_table(BUCKLING, &summary.buckling_table(), true)?;
    folder.write_table(FRICTION, &summary.friction_table(), true)?;
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
    for (name, table) in pictures(summary) {
        table.write_csv(&folder.path().join(format!("{name}.csv")))?;
    }
    summary.write(&folder.path().join("summary.json"))
}

/// What each picture shows, a column for each of its curves.
fn pictures(summary: &PlanSummary) -> [(&'static str, Table); 3] {
    let depth = || {
        let depths = summary.bit_depths_m.iter().map(|depth| Some(*depth));
        Column::numbers("bit_depth_m", depths.collect())
    };
    let at = |depth_m: f64, found: Option<f64>| (depth_m, found);
    let column = |name: String, found: &[(f64, Option<f64>)]| {
        let value = |depth: &f64| found.iter().find(|(at, _)| at == depth)?.1;
        Column::numbers(name, summary.bit_depths_m.iter().map(value).collect())
    };
    let curves = |quantity: &str, of: fn(&PlanPoint) -> Option<f64>| {
        let mut columns = vec![depth()];
        for model in &summary.models {
            for operation in &summary.operations {
                for friction in ["low", "expected", "high"] {
                    let points = summary.curve(model, operation, friction);
                    let found: Vec<_> = points.map(|one| at(one.bit_depth_m, of(one))).collect();
                    let name = format!("{operation}_{friction}_{model}_{quantity}");
                    columns.push(column(name, &found));
                }
            }
        }
        Table::new(columns)
    };
    let mut weights = vec![depth()];
    for operation in ["drill", "slide"] {
        for friction in ["low", "expected", "high"] {
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
        ("hook_load", curves("hook_load_N", |of| Some(of.scalars?.hook_load_N))),
        ("torque", curves("surface_torque_N_m", |of| Some(of.scalars?.surface_torque_N_m))),
        ("buckling_weight", Table::new(weights)),
    ]
}
