//! Dimensions by name.

use pyo3::prelude::*;
use wholestring_units::Dimension;

use crate::error;

/// The dimension with a name, such as `rotary speed`.
///
/// # Errors
/// An unknown name.
pub(crate) fn dimension(name: &str) -> PyResult<Dimension> {
    let found = Dimension::ALL.iter().find(|dimension| dimension.name() == name);
    found.copied().ok_or_else(|| {
        let names: Vec<&str> = Dimension::ALL.iter().map(|dimension| dimension.name()).collect();
        let names = names.join(", ");
        error::bad_input(format!("there is no dimension `{name}`: there are {names}"))
    })
}

/// A quantity of a dimension, such as `"10 s"` of a time, in SI.
#[pyfunction]
pub(crate) fn quantity(text: &str, dimension: &str) -> PyResult<f64> {
    let found = self::dimension(dimension)?;
    found.parse(text).map_err(|error| error::bad_input(error.to_string()))
}

/// SI unit of a dimension, such as `"rotary speed"`.
#[pyfunction]
pub(crate) fn si_unit(dimension: &str) -> PyResult<&'static str> {
    Ok(self::dimension(dimension)?.si_symbol())
}

/// Unit of a bare number of a dotted or short key of a case: SI, and `rpm` for rotary speeds, which
/// are in revolutions per minute in the case file. None for a pure number, a text, or an unknown
/// key.
#[pyfunction]
pub(crate) fn unit_of(key: &str) -> Option<&'static str> {
    wholestring_case::unit_of_key(key).map(|unit| unit.symbol)
}

/// Name of the dimension of a dotted or short key of a case; none for a pure number, a text, or an
/// unknown key.
#[pyfunction]
pub(crate) fn dimension_of(key: &str) -> Option<&'static str> {
    wholestring_case::dimension_at(key).map(Dimension::name)
}

/// Long form of a short key of a case; any other key unchanged.
#[pyfunction]
pub(crate) fn long_key(key: &str) -> &str {
    wholestring_case::long_key(key)
}
