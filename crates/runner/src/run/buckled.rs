//! Sentences about elements that are too long for their compression.

use wholestring::rod::buckled_element::BuckledElement;
use wholestring_judge::shorter_element;
use wholestring_units::{Dimension, UnitSet};

/// Reason why a live run stops.
pub(super) fn stopped(element: &BuckledElement, units: UnitSet) -> String {
    format!(
        "{} buckles between its nodes under a compression of {}, its own buckling load is {}: the \
         string folds there, which a real pipe does not. {}",
        named(element, units),
        force(element.compression_N, units),
        force(element.own_load_N, units),
        remedy(element, units),
    )
}

/// Reason why a weight on bit, N, is refused.
pub(super) fn refused(weight_N: f64, element: &BuckledElement, units: UnitSet) -> String {
    format!(
        "a weight on bit of {} exceeds what the mesh is made for: {} would buckle between its nodes \
         under a compression of {}, its own buckling load is {}. {}",
        force(weight_N, units),
        named(element, units),
        force(element.compression_N, units),
        force(element.own_load_N, units),
        remedy(element, units),
    )
}

fn named(element: &BuckledElement, units: UnitSet) -> String {
    let unit = Dimension::Length.unit_in(units);
    format!(
        "the element of {:.1} {unit} at {:.0} {unit}",
        unit.from_si(element.length_m),
        unit.from_si(element.md_m),
        unit = unit.symbol,
    )
}

fn remedy(element: &BuckledElement, units: UnitSet) -> String {
    format!(
        "Begin the simulation again with this weight in the operation or the schedule of the case, \
         which the automatic mesh is chosen for, or with mesh.element_length = {:?}",
        shorter_element(element, units)
    )
}

/// A force in four digits for a sentence.
fn force(force_N: f64, units: UnitSet) -> String {
    let unit = Dimension::Force.unit_in(units);
    let force = unit.from_si(force_N);
    let scale = libm::pow(10.0_f64, 3.0 - libm::log10(force.abs()).floor());
    let rounded = if scale.is_finite() { (force * scale).round() / scale } else { force };
    format!("{rounded} {}", unit.symbol)
}
