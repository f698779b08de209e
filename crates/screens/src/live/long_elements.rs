//! Sentences on elements that are too long for their compression, with marked quantities.

use wholestring::rod::buckled_element::BuckledElement;
use wholestring_judge::{Quantity, Rounding};
use wholestring_units::Dimension;

const fn force(force_N: f64) -> Quantity {
    Quantity::new(Dimension::Force, force_N, Rounding::Four)
}

fn in_words(element: &BuckledElement) -> String {
    let length = Quantity::new(Dimension::Length, element.length_m, Rounding::OneDecimal);
    format!("the element of {length} at {}", Quantity::depth(element.md_m))
}

fn remedy(element: &BuckledElement) -> String {
    let length_m = element.sufficient_length_m();
    let length = Quantity::new(Dimension::Length, length_m, Rounding::TwoDown);
    format!(
        "Start the string again with this weight in the case, or with mesh.element_length = \
         \"{length}\""
    )
}

/// The reason why a weight on bit, N, is refused.
pub(super) fn refused(weight_N: f64, element: &BuckledElement) -> String {
    format!(
        "The weight on bit of {} is more than the mesh is made for: {} would buckle between its \
         nodes under a compression of {}; its own buckling load is {}. It was not set. {}",
        force(weight_N),
        in_words(element),
        force(element.compression_N),
        force(element.own_load_N),
        remedy(element)
    )
}

/// The reason why a string cannot continue.
pub(super) fn stopped(element: &BuckledElement) -> String {
    format!(
        "The string cannot continue from here: {} buckles between its nodes under a compression of \
         {}; its own buckling load is {}. {}",
        in_words(element),
        force(element.compression_N),
        force(element.own_load_N),
        remedy(element)
    )
}
