//! `report.html` and the pictures of a bit test, made from the files in its folder.

use std::path::Path;

use serde_json::{Value as Json, json};
use wholestring_report::{BitTest, PageTable, Plot, bit_test_html, bit_test_plots};
use wholestring_results::{BitTestSummary, ResultsError};
use wholestring_units::UnitSet;

use super::{
    points::common,
    tables::{BOTTOM, LAW, POINTS},
};
use crate::{
    page::{history::bottom_picture, inputs::page_tables, table},
    results_kind::Results,
};

/// The picture that is drawn by default.
const DRILL_OFF: &str = "drill-off";

impl Results for BitTest {
    const NOUN: &'static str = "a bit test";
    const TABLE: &'static str = POINTS;
    const PICTURES: &'static [&'static str] = &[DRILL_OFF];
    const FILES: &'static [&'static str] = &[LAW];

    fn gather(folder: &Path, units: Option<UnitSet>) -> Result<Self, ResultsError> {
        let summary = BitTestSummary::read(&folder.join("summary.json"))?;
        let mut bottoms = Vec::new();
        for point in &summary.points {
            bottoms.push(match point.outcome {
                Some(_) => {
                    let table = table(&folder.join(&point.point), BOTTOM)?;
                    bottom_picture(&table, &Vec::from_iter(0..table.rows()))
                }
                None => None,
            });
        }
        let inputs = inputs(&summary.settings);
        Ok(Self::new(summary, bottoms, inputs, units))
    }

    fn html(&self) -> Option<String> {
        self.has_points().then(|| bit_test_html(self))
    }

    fn plots(&self) -> Vec<Plot> {
        bit_test_plots(self, &self.head.units)
    }
}

/// Settings common to all points, as tables.
fn inputs(settings: &Json) -> Vec<PageTable> {
    let common = common(settings);
    let mut page_tables = page_tables(&json!({
        "bit_face": common["bit"]["face"],
        "bit_test": common["bit_test"],
        "rock": common["rock"],
    }));
    // A bit test has none of the other inputs of a case.
    page_tables.retain(|page_table| !page_table.rows.is_empty());
    page_tables
}
