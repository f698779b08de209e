//! The page of a reach, and its pictures.

mod figures;
mod page;
mod sentences;

pub use figures::{REACH_PICTURES, reach_plots};
pub use page::reach_html;
pub use sentences::{end_of_limit, reach_answers, reach_notes};

use wholestring::operation::OperationKind;
use wholestring_judge::DepthLimit;
use wholestring_results::{
    ReachLimit, ReachMargin, ReachOfFriction, ReachSummary, UncertainTables,
};
use wholestring_units::UnitSet;

use crate::{Cell, Fact, PageHead, uncertain::Uncertain};

/// A reach with the head of its page. Numbers are SI.
#[derive(Debug, Clone, PartialEq)]
pub struct Reach {
    /// Head of the page, under the name of the case.
    pub head: PageHead,
    /// The answer.
    pub summary: ReachSummary,
    /// Margins against depth.
    curves: Vec<ReachCurve>,
}

impl Reach {
    /// The page of a reach and of the rows of `reach.parquet`; it opens in these units, by default
    /// in those of the case.
    pub fn new(summary: ReachSummary, margins: &[ReachMargin], units: Option<UnitSet>) -> Self {
        let title = format!("{}: reach", summary.case);
        let head = PageHead::new(title, units, Some(&summary.settings), facts(&summary));
        let curves = curves(margins, &summary);
        Self { head, summary, curves }
    }

    /// Effect of uncertain numbers; `None` where all are exact.
    fn uncertain(&self) -> Option<Uncertain<'_>> {
        Uncertain::new(self.summary.uncertain.as_ref(), &UncertainTables::REACH)
    }

    /// Whether the page distinguishes friction factors.
    fn has_frictions(&self) -> bool {
        self.summary.frictions.len() > 1
    }

    /// The limits of all operations at all friction factors.
    fn limits(&self) -> impl Iterator<Item = (&ReachOfFriction, &ReachLimit)> {
        let frictions = self.summary.frictions.iter();
        frictions.flat_map(|reach| reach.limits.iter().map(move |limit| (reach, limit)))
    }
}

/// Whether a limit stops the well first at its friction.
fn is_first(reach: &ReachOfFriction, limit: &ReachLimit) -> bool {
    reach
        .first
        .as_ref()
        .is_some_and(|first| first.limit == limit.limit && first.operation == limit.operation)
}

fn facts(summary: &ReachSummary) -> Vec<Fact> {
    vec![
        Fact::new("From", Cell::quantity(summary.from_m, "length")),
        Fact::new("To", Cell::quantity(summary.to_m, "length")),
        Fact::new("Inclination", Cell::quantity(summary.inclination_rad, "angle")),
    ]
}

// Margins of a reach as curves against depth.

/// The margin of a limit against the depth of the bit.
#[derive(Debug, Clone, PartialEq)]
struct ReachCurve {
    /// The operation.
    operation: OperationKind,
    /// The limit.
    limit: DepthLimit,
    /// Place of the friction.
    friction: usize,
    /// Depth of the bit, m, and the remaining margin; not a number for a string that is locked up.
    points: Vec<(f64, f64)>,
}

/// Curves of `reach.parquet`: rows that differ only in depth.
fn curves(margins: &[ReachMargin], summary: &ReachSummary) -> Vec<ReachCurve> {
    let key = |row: &ReachMargin| (row.operation, row.limit, row.friction.map(f64::to_bits));
    let curve = |rows: &[ReachMargin]| {
        let first = rows.first()?;
        let place = summary.frictions.iter().position(|reach| reach.friction == first.friction);
        Some(ReachCurve {
            operation: first.operation,
            limit: first.limit,
            friction: place.unwrap_or(0),
            points: rows.iter().map(|row| (row.bit_depth_m, row.margin)).collect(),
        })
    };
    margins.chunk_by(|one, other| key(one) == key(other)).filter_map(curve).collect()
}

#[cfg(test)]
mod tests;
