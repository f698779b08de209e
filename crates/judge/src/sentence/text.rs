//! Quantities and places within a sentence.

use wholestring::outcome::QuantityKind;
use wholestring_units::Dimension;

use crate::{Check, Quantity, Rounding, quantities};

pub(crate) const fn force(force_N: f64) -> Quantity {
    Quantity::new(Dimension::Force, force_N, Rounding::Four)
}

pub(crate) const fn torque(torque_N_m: f64) -> Quantity {
    Quantity::new(Dimension::Torque, torque_N_m, Rounding::Four)
}

pub(crate) const fn length(length_m: f64) -> Quantity {
    Quantity::new(Dimension::Length, length_m, Rounding::Four)
}

/// A radial length, in small units.
pub(crate) const fn across(length_m: f64) -> Quantity {
    Quantity::new(Dimension::Diameter, length_m, Rounding::Four)
}

/// A length of elements, rounded down.
pub(crate) const fn element_length(length_m: f64) -> Quantity {
    Quantity::new(Dimension::Length, length_m, Rounding::TwoDown)
}

pub(crate) const fn depth(md_m: f64) -> Quantity {
    Quantity::depth(md_m)
}

/// A value of the check's kind of quantity.
pub(crate) fn of_kind(kind: QuantityKind, si: f64) -> String {
    match quantities::dimension(kind) {
        Some(dimension) => Quantity::new(dimension, si, Rounding::Four).to_string(),
        None => format!("{si:.3} {}", kind.unit()).trim_end().to_owned(),
    }
}

/// Stretches shorter than this, m, are named by one depth: a foot, to which depths are written.
const MIN_STRETCH_M: f64 = 0.3048;

/// ` at 4310 m`, ` from 50 m to 3350 m` or nothing.
pub(crate) fn place(check: &Check) -> String {
    match (check.md_m, check.to_md_m) {
        (Some(from), Some(to)) if to - from < MIN_STRETCH_M => format!(" at {}", depth(from)),
        (Some(from), Some(to)) => format!(" from {} to {}", depth(from), depth(to)),
        (Some(at), None) => format!(" at {}", depth(at)),
        _ => String::new(),
    }
}

/// `12 %`, below ten per cent with one decimal.
pub(crate) fn percent(part: f64) -> String {
    let percent = part * 100.0;
    if percent.abs() < 10.0 { format!("{percent:.1} %") } else { format!("{percent:.0} %") }
}

/// A factor in two decimals; `over 100` of a large one.
pub(crate) fn factor(factor: f64) -> String {
    match factor {
        factor if factor.is_nan() => "–".to_owned(),
        factor if factor >= 100.0 => "over 100".to_owned(),
        factor => format!("{factor:.2}"),
    }
}
