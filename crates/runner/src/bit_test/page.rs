//! `report.html` and the pictures of a bit test, made from the files in its folder.

use std::path::Path;

use wholestring_report::{BitTest, BottomPicture, Plot, bit_test_html, bit_test_plots};
use wholestring_results::{BitTestSummary, ResultsError};
use wholestring_units::UnitSet;

use super::tables::{BOTTOM, LAW, POINTS};
use crate::{page::table, results_kind::Results};

/// The picture that is drawn by default.
const DRILL_OFF: &str = "drill-off";

impl Results for BitTest {
    const NOUN: &'static str = "a bit test";
    const TABLE: &'static str = POINTS;
    const PICTURES: &'static [&'static str] = &[DRILL_OFF];
    const FILES: &'static [&'static str] = &[LAW];

    fn check_summary(path: &Path) -> Result<(), ResultsError> {
        BitTestSummary::read(path).map(drop)
    }

    fn gather(folder: &Path, units: Option<UnitSet>) -> Result<Self, ResultsError> {
        let summary = BitTestSummary::read(&folder.join("summary.json"))?;
        let mut bottoms = Vec::new();
        for point in &summary.points {
            bottoms.push(match point.outcome {
                Some(_) => BottomPicture::of_table(&table(&folder.join(&point.point), BOTTOM)?),
                None => None,
            });
        }
        Ok(Self::new(summary, bottoms, units))
    }

    fn html(&self) -> Option<String> {
        self.has_points().then(|| bit_test_html(self))
    }

    fn plots(&self) -> Vec<Plot> {
        bit_test_plots(self, &self.head.units)
    }
}
