//! `report.html` and the picture of a reach, made from the files in its folder.

use std::path::Path;

use wholestring_report::{Plot, REACH_PICTURES, Reach, reach_html, reach_plots};
use wholestring_results::{ReachSummary, ResultsError};
use wholestring_units::UnitSet;

use super::tables::REACH;
use crate::{page::read_rows, results_kind::Results};

impl Results for Reach {
    const NOUN: &'static str = "a reach";
    const TABLE: &'static str = REACH;
    const PICTURES: &'static [&'static str] = &REACH_PICTURES;
    const WITH_NUMBERS: bool = true;

    fn check_summary(path: &Path) -> Result<(), ResultsError> {
        ReachSummary::read(path).map(drop)
    }

    fn gather(folder: &Path, units: Option<UnitSet>) -> Result<Self, ResultsError> {
        let summary = ReachSummary::read(&folder.join("summary.json"))?;
        Ok(Self::new(summary, &read_rows(folder, REACH)?, units))
    }

    fn html(&self) -> Option<String> {
        Some(reach_html(self))
    }

    fn plots(&self) -> Vec<Plot> {
        reach_plots(self, &self.head.units)
    }
}
