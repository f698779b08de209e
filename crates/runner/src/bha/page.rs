//! `report.html` and the pictures of a static BHA analysis, made from the files in its folder.

use std::path::Path;

use wholestring_report::{Bha, Plot, bha_html, bha_plots};
use wholestring_results::{BhaSummary, ResultsError};
use wholestring_units::UnitSet;

use crate::{page::table, results_kind::Results};

/// Name of the table of the nodes, which identifies a folder of results.
pub(super) const NODES: &str = "bha";

/// The picture that is drawn by default.
const VIEWS: &str = "views";

impl Results for Bha {
    const NOUN: &'static str = "a static BHA analysis";
    const TABLE: &'static str = NODES;
    const PICTURES: &'static [&'static str] = &[VIEWS];

    fn check_summary(path: &Path) -> Result<(), ResultsError> {
        BhaSummary::read(path).map(drop)
    }

    fn gather(folder: &Path, units: Option<UnitSet>) -> Result<Self, ResultsError> {
        let summary = BhaSummary::read(&folder.join("summary.json"))?;
        Ok(Self::new(summary, &table(folder, NODES)?, units))
    }

    fn html(&self) -> Option<String> {
        Some(bha_html(self))
    }

    fn plots(&self) -> Vec<Plot> {
        bha_plots(self, &self.head.units)
    }
}
