//! `report.html` and the pictures of a calibration, made from the files in its folder.

use std::path::Path;

use wholestring_report::{
    CALIBRATION_PICTURES, Calibration, Plot, calibration_html, calibration_plots,
};
use wholestring_results::{CalibrationRows, CalibrationSummary, ResultsError};
use wholestring_units::UnitSet;

use super::{
    tables::{BANDS, POINTS, PROFILES},
    toml::FRAGMENT,
};
use crate::{page::read_rows, results_kind::Results};

impl Results for Calibration {
    const NOUN: &'static str = "a calibration";
    const TABLE: &'static str = PROFILES;
    const PICTURES: &'static [&'static str] = &CALIBRATION_PICTURES;
    const FILES: &'static [&'static str] = &[FRAGMENT];

    fn check_summary(path: &Path) -> Result<(), ResultsError> {
        CalibrationSummary::read(path).map(drop)
    }

    fn gather(folder: &Path, units: Option<UnitSet>) -> Result<Self, ResultsError> {
        let summary = CalibrationSummary::read(&folder.join("summary.json"))?;
        let rows = CalibrationRows {
            profiles: read_rows(folder, PROFILES)?,
            readings: read_rows(folder, POINTS)?,
            bands: read_rows(folder, BANDS)?,
        };
        Ok(Self::new(summary, rows, units))
    }

    fn html(&self) -> Option<String> {
        Some(calibration_html(self))
    }

    fn plots(&self) -> Vec<Plot> {
        calibration_plots(self, &self.head.units)
    }
}
