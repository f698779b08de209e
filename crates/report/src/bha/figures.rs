//! All pictures of an assembly at rest.

use super::{Bha, BhaSweep, bending, sweeps, views};
use crate::{Plot, plots::Shown};

/// Every picture of an assembly, in a set of units (`si`, `metric` or `field`): `views` (from the side
/// and from above), `bending` (moment and stress), and a picture of each thing that was varied (`toolface`,
/// `weight`, `inclination`); none where nothing was solved.
pub fn bha_plots(bha: &Bha, units: &str) -> Vec<Plot> {
    let shown = Shown::new(&bha.head.dimensions, units);
    if bha.from_bit_m.len() < 2 {
        return Vec::new();
    }
    let plot = |name: &str, figure| Plot { name: name.into(), figure };
    let mut plots = vec![
        plot("views", views::figure(bha, shown)),
        plot("bending", bending::figure(bha, shown)),
    ];
    let varied = |of: &BhaSweep| plot(&of.name, sweeps::figure(bha, of, shown));
    plots.extend(bha.sweeps.iter().map(varied));
    plots
}

/// How far from the bit a picture along the assembly goes, m: a little above its collars, below the
/// jointed pipe, where it has any; its end otherwise.
pub(super) fn shown_to_m(bha: &Bha) -> f64 {
    const ABOVE: f64 = 1.1;
    let solved_m = bha.from_bit_m.last().copied().unwrap_or(0.0);
    let jointed = bha.parts.iter().find(|part| part.is_jointed).map(|part| part.from_bit_m);
    let collars_m = jointed.filter(|from_m| *from_m > 0.0).unwrap_or(bha.length_m);
    (ABOVE * collars_m.min(bha.length_m)).min(solved_m)
}

/// A quantity in three digits, with its unit.
pub(super) fn three(shown: Shown<'_>, si: f64, dimension: &str) -> String {
    let value = shown.value(si, dimension);
    let value: f64 = format!("{value:.2e}").parse().unwrap_or(value);
    let number = value.to_string().replace('-', "\u{2212}");
    format!("{number} {}", shown.symbol(dimension)).trim_end().to_owned()
}

/// What the facts of the head say, on one line.
pub(super) fn conditions(bha: &Bha, shown: Shown<'_>) -> String {
    let facts = bha.head.facts.iter().take(5);
    facts.filter_map(|fact| shown.fact(fact)).collect::<Vec<_>>().join("; ")
}
