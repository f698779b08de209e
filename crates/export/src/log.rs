//! A log against bit depth.

use wholestring_units::Dimension;

/// Curves against the measured depth of the bit.
#[derive(Debug, Clone, PartialEq)]
pub struct Log {
    /// Its name: `trip out, soft string, expected friction`.
    pub name: String,
    /// Measured depths of the bit, m, ascending.
    pub bit_depths_m: Vec<f64>,
    /// Results at each depth.
    pub curves: Vec<Curve>,
}

/// A curve of a log.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// Its short name: `HKLD`.
    pub mnemonic: &'static str,
    /// Its class in WITSML 1.4.1.1: `hookload (average)`.
    pub class: &'static str,
    /// Its meaning, in a sentence.
    pub meaning: &'static str,
    /// Its dimension.
    pub dimension: Dimension,
    /// Its values, SI; none if there is no result.
    pub values: Vec<Option<f64>>,
}
