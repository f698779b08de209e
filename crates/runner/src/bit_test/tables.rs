//! The tables of a bit test, and its page and pictures, made from the files in its folder.

use std::path::Path;

use wholestring::rock::{TrialOutcome, bit_face::BottomHole};
use wholestring_report::{BitTest, BottomPicture, Plot, bit_test_html, bit_test_plots};
use wholestring_results::{
    BitTestPoint, BitTestSummary, BottomHoleCell, Column, ResultsError, ResultsFolder, Row as _,
    Table,
};
use wholestring_units::UnitSet;

use super::points::rpm;
use crate::{page::table, record::rows::bottom_cells, results_kind::Results};

/// Name of the table of all points, without its extension.
pub(super) const POINTS: &str = "bit-test";

/// Name of the table of a point's bottom hole, without its extension, and the name of its
/// operation.
pub(super) const BOTTOM: &str = "bottom_hole";
const OPERATION: &str = "bit_test";

/// Name of the table for the law "table".
const LAW: &str = "bit-table.csv";

/// A number of an outcome.
type Number = (&'static str, fn(&TrialOutcome) -> f64);

/// Writes the table for the law "table" if every point is finished; otherwise removes that of an
/// earlier test.
pub(super) fn write_law(
    folder: &ResultsFolder,
    points: &[BitTestPoint],
) -> Result<(), ResultsError> {
    let outcomes: Option<Vec<TrialOutcome>> = points.iter().map(|point| point.outcome).collect();
    match outcomes {
        Some(outcomes) => law(&outcomes).write_csv(&folder.path().join(LAW)),
        None => folder.remove(LAW),
    }
}

/// The columns that `[bit.table] file` requires.
fn law(outcomes: &[TrialOutcome]) -> Table {
    // A bit that bounces on rock that it does not break may end slightly higher, but a law contains
    // no negative numbers.
    let columns: [Number; 6] = [
        ("weight_on_bit_N", |outcome| outcome.weight_on_bit_N),
        ("rotary_speed_rpm", |outcome| rpm(outcome.rotary_speed_rad_per_s)),
        ("rate_of_penetration_m_per_h", |outcome| {
            3600.0 * outcome.rate_of_penetration_m_per_s.max(0.0)
        }),
        ("torque_N_m", |outcome| outcome.torque_N_m.max(0.0)),
        ("torque_std_N_m", |outcome| outcome.torque_std_N_m),
        ("weight_on_bit_std_N", |outcome| outcome.weight_on_bit_std_N),
    ];
    let column = |(name, value_of): Number| {
        Column::numbers(name, outcomes.iter().map(|outcome| Some(value_of(outcome))).collect())
    };
    Table::new(columns.map(column).into())
}

/// The bottom hole left by a point, as for a run.
pub(super) fn bottom(bottom: &BottomHole) -> Table {
    BottomHoleCell::table(bottom_cells(bottom, OPERATION))
}

// `report.html` and the pictures of a bit test, made from the files in its folder.

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
