//! The page, the pictures and the workbook of a plan, made from the files in its folder.

use std::path::Path;

use wholestring_report::{PLAN_PICTURES, Plan, Plot, plan_html, plan_plots};
use wholestring_results::{PlanSummary, ResultsError, ResultsFolder, Table, UncertainTables};
use wholestring_units::UnitSet;

use super::{
    files::{ALONG, BROOMSTICK, FATIGUE, PEAKS_TIME, Tables, WEAR, WORKBOOK},
    page,
    workbook::workbook,
};
use crate::{
    error::Error,
    page::{read_rows, rows_of, table},
    results_kind::Results,
};

/// Writes the workbook in these units.
pub(super) fn write_workbook(
    folder: &ResultsFolder,
    summary: &PlanSummary,
    tables: &Tables,
    units: UnitSet,
) -> Result<(), Error> {
    let bytes = workbook(summary, tables, units).bytes().map_err(Error::failed)?;
    Ok(folder.write_file(WORKBOOK, &bytes)?)
}

/// Rewrites page, pictures and workbook.
pub(super) fn write_again(folder: &ResultsFolder, units: Option<UnitSet>) -> Result<(), Error> {
    let summary = PlanSummary::read(&folder.path().join("summary.json"))?;
    let peaks_time = table(folder.path(), PEAKS_TIME)?;
    let samples = rows_of(&peaks_time, &folder.path().join(format!("{PEAKS_TIME}.parquet")))?;
    let plan = Plan::new(summary, read_rows(folder.path(), ALONG)?, &samples, units);
    let units = plan.head.units.parse().unwrap_or_default();
    plan.write(folder, false)?;
    let tables = tables(folder.path(), &plan.summary, peaks_time)?;
    write_workbook(folder, &plan.summary, &tables, units)
}

/// The workbook of the plan in a folder.
pub(crate) fn workbook_of(
    folder: &Path,
    units: UnitSet,
) -> Result<wholestring_report::Workbook, ResultsError> {
    let summary = PlanSummary::read(&folder.join("summary.json"))?;
    let tables = tables(folder, &summary, table(folder, PEAKS_TIME)?)?;
    Ok(workbook(&summary, &tables, units))
}

/// Tables of a plan that are not in its summary.
fn tables(folder: &Path, summary: &PlanSummary, peaks_time: Table) -> Result<Tables, ResultsError> {
    // The table of limits is for programs only; the page reads them from the summary.
    let [along, fatigue, wear] = [ALONG, FATIGUE, WEAR].map(|name| table(folder, name));
    let samples = summary.uncertain.as_ref().map(|_| table(folder, UncertainTables::PLAN.samples));
    let samples = samples.transpose()?;
    Ok(Tables {
        along: along?,
        limits: Table::new(Vec::new()),
        fatigue: fatigue?,
        wear: wear?,
        samples,
        peaks_time,
    })
}

/// Page data of a plan.
pub(super) fn gather(folder: &Path, units: Option<UnitSet>) -> Result<Plan, ResultsError> {
    let summary = PlanSummary::read(&folder.join("summary.json"))?;
    Ok(Plan::new(summary, read_rows(folder, ALONG)?, &read_rows(folder, PEAKS_TIME)?, units))
}

// Contents of a folder with a plan.

impl Results for Plan {
    const NOUN: &'static str = "a plan";
    const TABLE: &'static str = BROOMSTICK;
    const PICTURES: &'static [&'static str] = &PLAN_PICTURES;
    const WITH_NUMBERS: bool = true;
    const FILES: &'static [&'static str] = &[WORKBOOK];

    fn check_summary(path: &Path) -> Result<(), ResultsError> {
        PlanSummary::read(path).map(drop)
    }

    fn gather(folder: &Path, units: Option<UnitSet>) -> Result<Self, ResultsError> {
        page::gather(folder, units)
    }

    fn html(&self) -> Option<String> {
        Some(plan_html(self))
    }

    fn plots(&self) -> Vec<Plot> {
        plan_plots(self, &self.head.units)
    }

    fn write_again(folder: &ResultsFolder, units: Option<UnitSet>) -> Result<(), Error> {
        page::write_again(folder, units)
    }
}
