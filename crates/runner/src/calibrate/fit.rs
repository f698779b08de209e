//! The options of a calibration.

use wholestring::outcome::ModelKind;
use wholestring_plan::calibration::Parameter;

/// Parameters to fit.
#[derive(Debug, Clone, PartialEq)]
pub struct Fit {
    /// One factor for cased and open hole.
    pub one_factor: bool,
    /// A factor for each section of the hole instead of one for casing and one for open hole.
    pub by_section: bool,
    /// Separate rotational and axial friction.
    pub friction_around: bool,
    /// Whether to fit the block weight even if the case gives it; otherwise it is fitted only if
    /// the case does not.
    pub block_weight: bool,
    /// Whether to fit the torque on bit on bottom.
    pub bit_torque: bool,
    /// Parameters that are kept fixed, with their values.
    pub hold: Vec<(Parameter, f64)>,
    /// Standard errors of pick-up and slack-off weights and of rotating weights, N, and of torques,
    /// N·m; `None` to estimate them.
    pub errors: [Option<f64>; 3],
    /// Residuals larger than this many standard errors are outliers.
    pub outlier_beyond: f64,
    /// Whether outliers found by a robust fit are left out of the fit and compared with it;
    /// otherwise the fit without them is shown for comparison.
    pub without_outliers: bool,
    /// Confidence of the bands.
    pub band_confidence: f64,
    /// The model used for predictions: soft or stiff.
    pub model: ModelKind,
}
