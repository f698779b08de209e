//! The page of a calibration, and its pictures.

mod figures;
mod page;

pub(crate) use figures::READINGS;
pub use figures::{CALIBRATION_PICTURES, calibration_plots, reading_words};
pub use page::calibration_html;

use std::path::Path;

use wholestring_plan::calibration::Parameter;
use wholestring_results::{CalibrationRows, CalibrationSummary, EstimateFound};
use wholestring_units::UnitSet;

use crate::{Cell, Fact, PageHead};

/// A calibration with the head of its page. Numbers are SI.
#[derive(Debug, Clone, PartialEq)]
pub struct Calibration {
    /// Head of the page, under the name of the case.
    pub head: PageHead,
    /// The answer.
    pub summary: CalibrationSummary,
    /// Readings, predictions with their bands, and profiles.
    rows: CalibrationRows,
}

impl Calibration {
    /// The page of a calibration and of the rows of its tables; it opens in these units, by default
    /// in those of the case.
    pub fn new(summary: CalibrationSummary, rows: CalibrationRows, units: Option<UnitSet>) -> Self {
        let title = format!("{}: measured friction", summary.title());
        let head = PageHead::new(title, units, Some(&summary.settings), facts(&summary));
        Self { head, summary, rows }
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
