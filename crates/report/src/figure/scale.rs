//! Two axes to the same scale.

use super::{Axis, Figure, Range, place::reached, ruler::Ruler};

/// The longer axis is at most this many times as long as the other, because a vertical well seen
/// from the side is a line.
const LONGEST: f64 = 4.0;

/// The figure with fixed ends of both axes, the same for all of its panels, neither much shorter
/// than the other.
pub(super) fn to_scale(figure: &Figure, shared: &[f64]) -> Figure {
    let mut scaled = figure.clone();
    let across = Ruler::new(&figure.shared, shared.iter().copied(), 1.0).ends();
    let up = figure
        .panels
        .iter()
        .map(|panel| Ruler::new(&panel.axis, reached(panel), 1.0).ends())
        .reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
        .unwrap_or((0.0, 1.0));
    fix(&mut scaled.shared, across, up);
    for panel in &mut scaled.panels {
        fix(&mut panel.axis, up, across);
    }
    scaled
}

/// Sets the ends of an axis, or as much as it needs relative to the other.
fn fix(axis: &mut Axis, (from, to): (f64, f64), other: (f64, f64)) {
    let missing = ((other.1 - other.0) / LONGEST - (to - from)).max(0.0);
    axis.range = Range::Fixed(from - 0.5 * missing, to + 0.5 * missing);
}

/// Width and height of a frame within this space that has both axes of a scaled figure to the same
/// scale.
pub(super) fn frame(figure: &Figure, (wide, high): (f64, f64)) -> (f64, f64) {
    let span = |axis: &Axis| match axis.range {
        Range::Fixed(from, to) if to > from => to - from,
        _ => 1.0,
    };
    let across = span(&figure.shared);
    let up = figure.panels.first().map_or(across, |panel| span(&panel.axis));
    let scale = (wide / across).min(high / up);
    (across * scale, up * scale)
}
