//! Files of a plan.

use wholestring_results::{
    PlanPeak, PlanSummary, ResultsError, ResultsFolder, Row as _, Table, UncertainTables,
};

use super::drawn::{pictures, with_mud, with_peaks};
use crate::uncertain;

/// Names of the tables, without their extensions.
pub(super) const ALONG: &str = "plan_along";
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

/// Tables that are not completely contained in the summary.
pub(super) struct Tables {
    /// The string along the hole.
    pub(super) along: Table,
    /// Limits.
    pub(super) limits: Table,
    /// Fatigue.
    pub(super) fatigue: Table,
    /// Casing wear.
    pub(super) wear: Table,
    /// Samples of uncertain inputs, if there are any.
    pub(super) samples: Option<Table>,
    /// Time histories of events.
    pub(super) peaks_time: Table,
}

/// Name of the workbook.
pub(super) const WORKBOOK: &str = "plan.xlsx";

/// Writes the summary and all tables, also as CSV, because the page links to them; and the numbers
/// of each picture.
pub(super) fn write(
    folder: &ResultsFolder,
    summary: &PlanSummary,
    tables: &Tables,
) -> Result<(), ResultsError> {
    folder.write_table(ALONG, &tables.along, true)?;
    folder.write_table(LIMITS, &tables.limits, true)?;
    folder.write_table(FATIGUE, &tables.fatigue, true)?;
    folder.write_table(WEAR, &tables.wear, true)?;
    let uncertain = summary.uncertain.as_ref().zip(tables.samples.as_ref());
    uncertain::write(folder, &UncertainTables::PLAN, uncertain)?;
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
        folder.write_table(PEAKS, &PlanPeak::table(&summary.peaks), true)?;
        folder.write_table(PEAKS_TIME, &tables.peaks_time, true)?;
        let peaks = with_peaks(summary, &tables.peaks_time);
        peaks.write_csv(&folder.path().join("peaks.csv"))?;
    }
    let picture = folder.path().join("hydraulics.csv");
    if summary.hydraulics.is_empty() {
        for name in ["plan_hydraulics.parquet", "plan_hydraulics.csv", "hydraulics.csv"] {
            folder.remove(name)?;
        }
    } else {
        let table = summary.hydraulics_table();
        folder.write_table(HYDRAULICS, &table, true)?;
        with_mud(summary, &table).write_csv(&picture)?;
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
