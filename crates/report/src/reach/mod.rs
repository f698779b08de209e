//! Contents of the page of a reach, and its pictures.

mod figures;
mod page;

pub use figures::{REACH_PICTURES, reach_plots};
pub use page::reach_html;

use wholestring::operation::OperationKind;

use crate::{PageHead, Severity, Uncertain};

/// A reach as its page shows it. Numbers are SI.
#[derive(Debug, Clone, PartialEq)]
pub struct Reach {
    /// Head of the page, under the name of the case.
    pub head: PageHead,
    /// The limit that stops the well first, a sentence for each friction, in SI, metric and field
    /// units.
    pub answers: [Vec<String>; 3],
    /// The reach of each operation at each friction.
    pub checks: Vec<ReachVerdict>,
    /// Further notes, in sentences, in the same units.
    pub notes: [Vec<String>; 3],
    /// Friction factors, as shown to users, in the order of the curves.
    pub frictions: Vec<String>,
    /// Every limit, as shown to users, in the order of the colours.
    pub titles: Vec<String>,
    /// The limits.
    pub limits: Vec<ReachRow>,
    /// Margins against depth.
    pub curves: Vec<ReachCurve>,
    /// First and last examined depth of the bit, m.
    pub depths_m: [f64; 2],
    /// Effect of uncertain numbers; `None` where all are exact.
    pub uncertain: Option<Uncertain>,
}

/// The reach of an operation at a friction.
#[derive(Debug, Clone, PartialEq)]
pub struct ReachVerdict {
    /// Its severity.
    pub severity: Severity,
    /// The friction factor in words.
    pub friction: String,
    /// The operation, a colon and the depth that it reaches, in SI, metric and field units.
    pub sentences: [String; 3],
}

/// A limit of an operation at a friction.
#[derive(Debug, Clone, PartialEq)]
pub struct ReachRow {
    /// The operation.
    pub operation: OperationKind,
    /// The limit, as shown to users.
    pub limit: String,
    /// Whether the string stops there.
    pub stops: bool,
    /// Place of the friction.
    pub friction: usize,
    /// Depth of the bit where it is first reached, m.
    pub depth_m: Option<f64>,
    /// Whether it is reached at the first depth already.
    pub already: bool,
    /// Remaining margin at the first and at the last depth.
    pub margins: [Option<f64>; 2],
    /// Measured depth of the smallest margin in the string, m.
    pub md_m: Option<f64>,
    /// Whether it stops the well first at this friction.
    pub first: bool,
}

/// The margin of a limit against the depth of the bit.
#[derive(Debug, Clone, PartialEq)]
pub struct ReachCurve {
    /// The operation.
    pub operation: OperationKind,
    /// The limit, as shown to users.
    pub limit: String,
    /// Place of the friction.
    pub friction: usize,
    /// Depth of the bit, m, and the remaining margin; not a number for a string that is locked up.
    pub points: Vec<(f64, f64)>,
}

#[cfg(test)]
mod tests;
