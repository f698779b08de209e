//! Dimensions by their names.

use pyo3::{exceptions::PyValueError, prelude::*};
use wholestring_units::Dimension;

/// The dimension of a name, such as `rotary speed`.
///
/// # Errors
/// A name that no dimension has.
pub(crate) fn dimension(name: &str) -> PyResult<Dimension> {
    let found = Dimension::ALL.iter().find(|of| of.name() == name);
    found.copied().ok_or_else(|| {
        let names: Vec<&str> = Dimension::ALL.iter().map(|of| of.name()).collect();
        let names = names.join(", ");
        PyValueError::new_err(format!("there is no dimension `{name}`: there are {names}"))
    })
}

/// A quantity of a dimension, such as `"10 s"` of a time, in SI.
#[pyfunction]
pub(crate) fn quantity(text: &str, dimension: &str) -> PyResult<f64> {
    let found = self::dimension(dimension)?;
    found.parse(text).map_err(|error| PyValueError::new_err(error.to_string()))
}

/// SI unit of a dimension, such as `"rotary speed"`.
#[pyfunction]
pub(crate) fn si_unit(dimension: &str) -> PyResult<&'static str> {
    Ok(self::dimension(dimension)?.si_symbol())
}

/// SI unit of what a dotted or short key of a case measures; nothing of a bare number, a text, or a
/// key that there is not.
#[pyfunction]
pub(crate) fn unit_of(key: &str) -> Option<&'static str> {
    // Stations are in metres and degrees, as in the case file.
    let bare = key.starts_with("well.stations.");
    wholestring_case::dimension_at(key).filter(|_| !bare).map(Dimension::si_symbol)
}
