//! The page of a static BHA analysis, and its pictures.

mod curves;
mod facts;
mod nodes;
mod tables;
mod views;

pub use facts::{bha_number, bha_quantity, bha_tendency};
pub use views::bha_plots;

use nodes::Varied;
use wholestring_results::{BhaSummary, BhaVaried, Table};
use wholestring_units::UnitSet;

use self::nodes::Nodes;
use crate::{PageHead, PageTable, dimensions::in_sets, inputs::input_tables};

/// A static BHA analysis with the head of its page. Numbers are SI; nodes are ordered from the bit
/// up; each pair is the part towards the high side and that to the right of it as one looks down
/// the hole.
#[derive(Debug, Clone, PartialEq)]
pub struct Bha {
    /// Head of the page, under the name of the case.
    pub head: PageHead,
    /// The answer.
    pub summary: BhaSummary,
    /// The string along its axis.
    nodes: Nodes,
}

impl Bha {
    /// The page of an analysis and of its nodes in `bha.parquet`; it opens in these units, by default
    /// in those of the case.
    pub fn new(summary: BhaSummary, nodes: &Table, units: Option<UnitSet>) -> Self {
        let title = format!("{}: static BHA analysis", summary.case);
        let head = PageHead::new(title, units, Some(&summary.settings), facts::facts(&summary));
        Self { head, summary, nodes: Nodes::new(nodes) }
    }

    /// Tendency of the inclination with this assembly, in sentences, in SI, metric and field units.
    pub(crate) fn tendency(&self) -> [Vec<String>; 3] {
        in_sets(|units| {
            let sentences = bha_tendency(&self.summary, units).into_iter();
            sentences
                .map(|sentence| sentence.replace(" deg", " °").replace(" -", " \u{2212}"))
                .collect()
        })
    }

    /// Warnings, in one sentence; `None` where there are none.
    pub(crate) fn message(&self) -> Option<String> {
        let warnings = self.summary.warnings();
        (!warnings.is_empty()).then(|| warnings.join("; "))
    }

    /// Tables of results and inputs.
    pub(crate) fn page_tables(&self) -> Vec<PageTable> {
        let mut tables = tables::page_tables(&self.summary);
        tables.extend(input_tables(&self.summary.settings));
        tables
    }

    /// Quantities that were varied.
    pub(crate) fn varied(&self) -> impl Iterator<Item = Varied<'_>> {
        BhaVaried::ALL.iter().filter_map(|varied| Varied::new(&self.summary, *varied))
    }

    /// Distances of the survey sensors from the bit, m.
    fn sensors_m(&self) -> impl Iterator<Item = f64> {
        self.summary.state.sag.iter().map(|sag| sag.from_bit_m)
    }
}

#[cfg(test)]
mod tests;
