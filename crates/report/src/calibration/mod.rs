//! The page of a calibration, and its pictures.

mod figures;
mod page;
mod rows;

pub(crate) use figures::READINGS;
pub use figures::{CALIBRATION_PICTURES, calibration_plots, reading_words};
pub use page::calibration_html;

use std::path::Path;

use wholestring_plan::calibration::Parameter;
use wholestring_results::{CalibrationSummary, CalibrationTables, EstimateFound};
use wholestring_units::UnitSet;

use self::rows::{CalibrationBand, CalibrationPoint};
use crate::{Cell, Fact, PageHead};

/// A calibration with the head of its page. Numbers are SI.
#[derive(Debug, Clone, PartialEq)]
pub struct Calibration {
    /// Head of the page, under the name of the case.
    pub head: PageHead,
    /// The answer.
    pub summary: CalibrationSummary,
    /// Every reading.
    points: Vec<CalibrationPoint>,
    /// Predictions with their bands.
    bands: Vec<CalibrationBand>,
    /// The profile of each estimate: value, excess of the sum of squares at it, and the same of a
    /// parabola.
    profiles: Vec<Vec<[f64; 3]>>,
}

impl Calibration {
    /// The page of a calibration and of its tables; it opens in these units, by default in those of
    /// the case.
    pub fn new(
        summary: CalibrationSummary,
        tables: &CalibrationTables,
        units: Option<UnitSet>,
    ) -> Self {
        let title = format!("{}: measured friction", summary.title());
        let estimates = summary.estimates.iter();
        Self {
            head: PageHead::new(title, units, Some(&summary.settings), facts(&summary)),
            points: rows::points(&tables.points),
            bands: rows::bands(&tables.bands),
            profiles: estimates
                .map(|estimate| rows::profile(&tables.profiles, &estimate.parameter))
                .collect(),
            summary,
        }
    }

    /// A text of the summary in these units.
    fn text(&self, text: &str, units: UnitSet) -> String {
        self.summary.texts.in_units(text, units)
    }
}

/// Dimension of a parameter; empty for a factor.
fn dimension(estimate: &EstimateFound) -> &'static str {
    match Parameter::from_name(&estimate.parameter) {
        Some(Parameter::BlockWeight) => "force",
        Some(Parameter::BitTorque) => "torque",
        _ => "",
    }
}

/// Key facts of the calibration.
fn facts(summary: &CalibrationSummary) -> Vec<Fact> {
    let fact = |label, text| Fact::new(label, Cell::Text(text));
    let file = Path::new(&summary.data).file_name();
    let file = file.map_or(summary.data.clone(), |name| name.to_string_lossy().into_owned());
    vec![
        fact("Readings", format!("{} of {file}", summary.readings)),
        fact("Model", format!("{} string", summary.model)),
        fact("χ²", format!("{:.1}", summary.chi2)),
        fact("Degrees of freedom", summary.degrees_of_freedom.to_string()),
    ]
}
