//! The options of a calibration, and their values as users write them, with their bounds.

use wholestring::outcome::ModelKind;
use wholestring_plan::calibration::Parameter;
use wholestring_units::Dimension;

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

// Option values that users write for a calibration, with their bounds.

fn positive(dimension: Dimension, text: &str) -> Result<f64, String> {
    let value = dimension.parse(text).map_err(|error| error.to_string())?;
    match value > 0.0 && value.is_finite() {
        true => Ok(value),
        false => Err("expected more than zero".to_owned()),
    }
}

/// A positive force, N.
///
/// # Errors
/// The expected form.
pub fn force(text: &str) -> Result<f64, String> {
    positive(Dimension::Force, text)
}

/// A positive depth, m.
///
/// # Errors
/// The expected form.
pub fn depth(text: &str) -> Result<f64, String> {
    positive(Dimension::Length, text)
}

/// A positive torque, N·m.
///
/// # Errors
/// The expected form.
pub fn torque(text: &str) -> Result<f64, String> {
    positive(Dimension::Torque, text)
}

fn number(text: &str, from: f64, to: f64) -> Result<f64, String> {
    let value: f64 = text.trim_end_matches('%').trim().parse().map_err(|_| "expected a number")?;
    match (from..=to).contains(&value) {
        true => Ok(value),
        false => Err(format!("expected {from} to {to}")),
    }
}

/// Number of standard errors beyond which residuals are outliers.
///
/// # Errors
/// The expected form.
pub fn beyond(text: &str) -> Result<f64, String> {
    number(text, 1.0, 100.0)
}

/// A confidence in per cent, as a fraction.
///
/// # Errors
/// The expected form.
pub fn confidence(text: &str) -> Result<f64, String> {
    Ok(number(text, 50.0, 99.9)? / 100.0)
}

/// Checks the value, SI, of a parameter that is kept fixed: from zero to the largest that its key in
/// a case may have.
///
/// # Errors
/// The expected range.
pub fn in_range(parameter: Parameter, value: f64) -> Result<(), String> {
    let (most, expected) = match parameter {
        Parameter::BlockWeight => (1e8, "0 to 100 000 kN"),
        Parameter::BitTorque => (1e6, "0 to 1000 kN.m"),
        _ => (2.0, "0 to 2"),
    };
    match (0.0..=most).contains(&value) {
        true => Ok(()),
        false => Err(format!("expected {expected}")),
    }
}

/// A parameter that is kept fixed, such as `friction_cased=0.2` or `block_weight=180kN`, SI.
///
/// # Errors
/// The expected form.
pub fn held(text: &str) -> Result<(Parameter, f64), String> {
    let (name, value) = text.split_once('=').ok_or("expected NAME=VALUE")?;
    let parameter = parameter(name.trim())?;
    let value = match dimension_of(parameter) {
        Some(dimension) => dimension.parse(value).map_err(|error| error.to_string())?,
        None => number(value, 0.0, 2.0)?,
    };
    in_range(parameter, value)?;
    Ok((parameter, value))
}

/// Dimension of the parameter with this name; `None` for a factor.
///
/// # Errors
/// There is no parameter with this name.
pub fn dimension(name: &str) -> Result<Option<Dimension>, String> {
    parameter(name).map(dimension_of)
}

fn dimension_of(parameter: Parameter) -> Option<Dimension> {
    match parameter {
        Parameter::BlockWeight => Some(Dimension::Force),
        Parameter::BitTorque => Some(Dimension::Torque),
        _ => None,
    }
}

/// Name of a parameter in options: without the unit, which the value has.
pub(super) fn name(parameter: Parameter) -> &'static str {
    parameter.name().trim_end_matches("_N_m").trim_end_matches("_N")
}

/// The parameter with this name, with or without its unit.
fn parameter(text: &str) -> Result<Parameter, String> {
    let parameter = Parameter::ALL
        .into_iter()
        .find(|parameter| [parameter.name(), name(*parameter)].contains(&text));
    parameter.ok_or_else(|| {
        let names: Vec<&str> = Parameter::ALL.into_iter().map(name).collect();
        format!("there is no parameter '{text}'; expected one of {}", names.join(", "))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn held_values_are_in_the_range_of_their_keys() {
        let held = |text| super::held(text);
        assert_eq!(held("block_weight=0kN"), Ok((Parameter::BlockWeight, 0.0)));
        assert_eq!(held("block_weight=180 kN"), Ok((Parameter::BlockWeight, 180e3)));
        for (text, expected) in [
            ("block_weight=-100kN", "expected 0 to 100 000 kN"),
            ("bit_torque=-1 kN.m", "expected 0 to 1000 kN.m"),
            ("bit_torque=1e9 kN.m", "expected 0 to 1000 kN.m"),
            ("friction_cased=-0.1", "expected 0 to 2"),
        ] {
            assert_eq!(held(text), Err(expected.to_owned()), "{text}");
        }
        assert!(in_range(Parameter::Friction, f64::NAN).is_err());
    }
}
