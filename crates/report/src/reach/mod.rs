//! What a page reports of how far a well can go, and its pictures.

mod figures;
mod page;

pub use figures::{REACH_PICTURES, reach_plots};
pub use page::reach_html;

use crate::{PageHead, Uncertain};

/// A reach as its page shows it. Numbers are SI.
#[derive(Debug, Clone, PartialEq)]
pub struct Reach {
    /// Under the name of the case.
    pub head: PageHead,
    /// What stops the well first, a sentence for each friction, in SI, metric and field units.
    pub answers: [Vec<String>; 3],
    /// What is to be known besides, in sentences, in the same units.
    pub notes: [Vec<String>; 3],
    /// Friction factors, as people say them, in the order of the curves.
    pub frictions: Vec<String>,
    /// Every limit that there is, as people say it, in the order of the colours.
    pub titles: Vec<String>,
    /// The limits.
    pub limits: Vec<ReachRow>,
    /// Margins against depth.
    pub curves: Vec<ReachCurve>,
    /// Depths of the bit between which it was looked for, m.
    pub depths_m: [f64; 2],
    /// What comes of numbers that are not known exactly; none where all are.
    pub uncertain: Option<Uncertain>,
}

/// A limit of an operation at a friction.
#[derive(Debug, Clone, PartialEq)]
pub struct ReachRow {
    /// The operation, as people say it.
    pub operation: String,
    /// The limit, as people say it.
    pub limit: String,
    /// Whether the string stops there.
    pub stops: bool,
    /// Place of the friction.
    pub friction: usize,
    /// Depth of the bit where it is met first, m.
    pub depth_m: Option<f64>,
    /// Whether it is met at the first depth already.
    pub already: bool,
    /// What is left of it at the first and at the last depth.
    pub margins: [Option<f64>; 2],
    /// Where in the string it is worst then, m.
    pub md_m: Option<f64>,
    /// Whether it is what stops the well first at this friction.
    pub first: bool,
}

/// The margin of a limit against the depth of the bit.
#[derive(Debug, Clone, PartialEq)]
pub struct ReachCurve {
    /// The operation, as people say it.
    pub operation: String,
    /// The limit, as people say it.
    pub limit: String,
    /// Place of the friction.
    pub friction: usize,
    /// Depth of the bit, m, and what is left; not a number of a string that is locked up.
    pub points: Vec<(f64, f64)>,
}

#[cfg(test)]
mod tests;
