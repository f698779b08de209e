//! Numbers of the hydraulics that are physically implausible.

use wholestring::mud::Hydraulics;
use wholestring_units::Dimension;

use crate::{Check, CheckKind, Quantity, Rounding, Severity};

/// A check of the first number of the hydraulics that is outside the range of drilling muds.
pub(crate) fn implausible(hydraulics: &Hydraulics) -> Option<Check> {
    let (name, value) = hydraulics.implausible()?;
    let ranges = Hydraulics::PLAUSIBLE.iter();
    let [least, most] = ranges.clone().find(|range| range.0 == name)?.2;
    let (words, noun, dimension) = described(name);
    let written = |si: f64| Quantity::new(dimension, si, Rounding::Five);
    let sentence = format!(
        "Implausible {noun}: the {words} is {}, outside {} to {}; check the diameters of string, \
         bit and hole, the flow rate and the mud",
        written(value),
        written(least),
        written(most),
    );
    let bound = if value < least { least } else { most };
    let numbers = match dimension {
        Dimension::Pressure => [Some(value), Some(bound)],
        _ => [None; 2],
    };
    Some(Check::of_readings(CheckKind::ImplausibleHydraulics, Severity::Error, numbers, sentence))
}

/// A number's name in words, its quantity and the dimension of that quantity: the name ends with
/// its unit.
fn described(name: &str) -> (String, &'static str, Dimension) {
    let (stem, noun, dimension) = match (name.strip_suffix("_N_m"), name.strip_suffix("_Pa")) {
        (Some(stem), _) => (stem, "torque", Dimension::Torque),
        (_, Some(stem)) => (stem, "pressure", Dimension::Pressure),
        (None, None) => (name.trim_end_matches("_N"), "force", Dimension::Force),
    };
    (stem.replace('_', " "), noun, dimension)
}
