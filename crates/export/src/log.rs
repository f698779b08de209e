//! A log against the depth of the bit.

use wholestring_units::Dimension;

/// Curves against the measured depth of the bit.
#[derive(Debug, Clone, PartialEq)]
pub struct Log {
    /// What it is called: `trip out, soft string, expected friction`.
    pub name: String,
    /// Measured depths of the bit, m, growing.
    pub bit_depths_m: Vec<f64>,
    /// What was found at each.
    pub curves: Vec<Curve>,
}

/// A curve of a log.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// Its short name: `HKLD`.
    pub mnemonic: &'static str,
    /// Its class in WITSML 1.4.1.1: `hookload (average)`.
    pub class: &'static str,
    /// What it is, in a sentence.
    pub meaning: &'static str,
    /// What it measures.
    pub dimension: Dimension,
    /// Its values, SI; none where there is no answer.
    pub values: Vec<Option<f64>>,
}
