//! The options of a calibration.

use wholestring::outcome::ModelKind;
use wholestring_plan::calibration::Parameter;

/// What is looked for.
#[derive(Debug, Clone, PartialEq)]
pub struct Fit {
    /// One factor for cased and open hole.
    pub one_factor: bool,
    /// A factor for each section of the hole in place of one for casing and one for open hole.
    pub by_section: bool,
    /// Friction around the hole apart from that along it.
    pub friction_around: bool,
    /// The weight of the block, although the case gives it; where it does not, it is looked for.
    pub block_weight: bool,
    /// The torque of the bit on bottom.
    pub bit_torque: bool,
    /// Numbers that are held.
    pub hold: Vec<(Parameter, f64)>,
    /// Standard errors of pick-up and slack-off weights and of rotating weights, N, and of torques,
    /// N·m; estimated where none is given.
    pub errors: [Option<f64>; 3],
    /// Residuals larger than so many of their standard errors are outliers.
    pub outlier_beyond: f64,
    /// Outliers, as a robust fit finds them, take no part in the fit and are held against it; otherwise what is
    /// found without them is shown beside it.
    pub without_outliers: bool,
    /// Confidence of the bands.
    pub band_confidence: f64,
    /// The model that predicts: soft or stiff.
    pub model: ModelKind,
}
