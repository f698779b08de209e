//! Common parts of the pictures of an assembly.

use wholestring_units::significant;

use super::Bha;
use crate::plots::DisplayUnits;

/// Distance from the bit up to which a picture along the assembly extends, m: a little above its
/// collars, below the jointed pipe, where it has any; its end otherwise.
pub(super) fn shown_to_m(bha: &Bha) -> f64 {
    const ABOVE: f64 = 1.1;
    let solved_m = bha.nodes.from_bit_m.last().copied().unwrap_or(0.0);
    let length_m = bha.summary.state.length_m;
    let mut parts = bha.summary.parts.iter();
    let jointed = parts.find(|part| part.joint_od_m.is_some()).map(|part| part.from_bit_m);
    let collars_m = jointed.filter(|from_m| *from_m > 0.0).unwrap_or(length_m);
    (ABOVE * collars_m.min(length_m)).min(solved_m)
}

/// A quantity in three digits, with its unit.
pub(super) fn three(display: DisplayUnits<'_>, si: f64, dimension: &str) -> String {
    let number = significant(display.value(si, dimension), 3).to_string().replace('-', "\u{2212}");
    format!("{number} {}", display.symbol(dimension)).trim_end().to_owned()
}

/// The facts of the head, on one line.
pub(super) fn conditions(bha: &Bha, display: DisplayUnits<'_>) -> String {
    let facts = bha.head.facts.iter().take(5);
    facts.filter_map(|fact| display.fact(fact)).collect::<Vec<_>>().join("; ")
}
