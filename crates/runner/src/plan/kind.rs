//! Contents of a folder with a plan.

use std::path::Path;

use wholestring_report::{PLAN_PICTURES, Plan, Plot, plan_html, plan_plots};
use wholestring_results::{PlanSummary, ResultsError, ResultsFolder};
use wholestring_units::UnitSet;

use super::{
    files::{BROOMSTICK, WORKBOOK},
    page,
};
use crate::{error::Error, results_kind::Results};

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
