//! `report.html` and the pictures of linear vibration, made from the files in its folder.

use std::path::Path;

use wholestring_report::{MODES_PICTURES, Modes, Plot, modes_html, modes_plots};
use wholestring_results::{ModesRows, ModesSummary, ResultsError, Table};
use wholestring_units::UnitSet;

use super::tables::{ANSWER, DIAGRAM, MODES, SHAPES, STABILITY};
use crate::{
    page::{read_rows, table},
    results_kind::Results,
};

impl Results for Modes {
    const NOUN: &'static str = "modes";
    const TABLE: &'static str = MODES;
    const PICTURES: &'static [&'static str] = &MODES_PICTURES;
    const WITH_NUMBERS: bool = true;

    fn check_summary(path: &Path) -> Result<(), ResultsError> {
        ModesSummary::read(path).map(drop)
    }

    fn gather(folder: &Path, units: Option<UnitSet>) -> Result<Self, ResultsError> {
        let summary = ModesSummary::read(&folder.join("summary.json"))?;
        let rows = ModesRows {
            shapes: read_rows(folder, SHAPES)?,
            campbell: read_rows(folder, DIAGRAM)?,
            response: read_rows(folder, ANSWER)?,
        };
        let stability = match &summary.torsional_stability {
            Some(_) => table(folder, STABILITY)?,
            None => Table::new(Vec::new()),
        };
        Ok(Self::new(summary, rows, &stability, units))
    }

    fn html(&self) -> Option<String> {
        Some(modes_html(self))
    }

    fn plots(&self) -> Vec<Plot> {
        modes_plots(self, &self.head.units)
    }
}
