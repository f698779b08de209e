//! What users write to a calibration, with its bounds.

use wholestring_plan::calibration::Parameter;
use wholestring_units::Dimension;

fn positive(dimension: Dimension, text: &str) -> Result<f64, String> {
    let value = dimension.parse(text).map_err(|error| error.to_string())?;
    match value > 0.0 && value.is_finite() {
        true => Ok(value),
        false => Err("expected more than zero".to_owned()),
    }
}

/// More force than none, N.
///
/// # Errors
/// What was expected.
pub fn force(text: &str) -> Result<f64, String> {
    positive(Dimension::Force, text)
}

/// More depth than none, m.
///
/// # Errors
/// What was expected.
pub fn depth(text: &str) -> Result<f64, String> {
    positive(Dimension::Length, text)
}

/// More torque than none, N·m.
///
/// # Errors
/// What was expected.
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

/// Beyond how many of their standard errors residuals are outliers.
///
/// # Errors
/// What was expected.
pub fn beyond(text: &str) -> Result<f64, String> {
    number(text, 1.0, 100.0)
}

/// A confidence in per cent, as a part of one.
///
/// # Errors
/// What was expected.
pub fn confidence(text: &str) -> Result<f64, String> {
    Ok(number(text, 50.0, 99.9)? / 100.0)
}

/// What is held, such as `friction_cased=0.2` or `block_weight=180kN`, SI.
///
/// # Errors
/// What was expected.
pub fn held(text: &str) -> Result<(Parameter, f64), String> {
    let (name, value) = text.split_once('=').ok_or("expected NAME=VALUE")?;
    let of = parameter(name.trim())?;
    let value = match dimension_of(of) {
        Some(dimension) => dimension.parse(value).map_err(|error| error.to_string()),
        None => number(value, 0.0, 2.0),
    };
    Ok((of, value?))
}

/// What a number measures that is held by this name; nothing of a factor.
///
/// # Errors
/// Nothing is called that.
pub fn dimension(name: &str) -> Result<Option<Dimension>, String> {
    parameter(name).map(dimension_of)
}

fn dimension_of(of: Parameter) -> Option<Dimension> {
    match of {
        Parameter::BlockWeight => Some(Dimension::Force),
        Parameter::BitTorque => Some(Dimension::Torque),
        _ => None,
    }
}

/// What is called that, with its unit or without.
fn parameter(name: &str) -> Result<Parameter, String> {
    // Without the unit that the value has itself.
    let short = |of: Parameter| of.name().trim_end_matches("_N_m").trim_end_matches("_N");
    let of = Parameter::ALL.into_iter().find(|of| of.name() == name || short(*of) == name);
    of.ok_or_else(|| {
        let names: Vec<&str> = Parameter::ALL.into_iter().map(short).collect();
        format!("nothing is called '{name}'; expected one of {}", names.join(", "))
    })
}
