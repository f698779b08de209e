//! Depths of the bit.

use crate::Setup;

/// Depths closer than this are one, m.
const SAME_M: f64 = 1.0;

/// Returns this number of depths of the bit, m, evenly from one to another, and the lower ends of
/// hole sections between them. Without the first they begin where drill pipe does: with the
/// bottom-hole assembly in the hole and little more.
pub fn bit_depths_m(setup: &Setup, from_m: Option<f64>, to_m: f64, count: usize) -> Vec<f64> {
    let from_m = from_m.unwrap_or_else(|| setup.shallowest_m()).min(to_m);
    let steps = count.max(2) - 1;
    // The ends are returned unchanged.
    let place = |step: usize| match step {
        0 => from_m,
        step if step == steps => to_m,
        step => from_m + (to_m - from_m) * step as f64 / steps as f64,
    };
    let ends = setup.well.hole.sections().iter().map(|section| section.to_md_m);
    let ends: Vec<f64> =
        ends.filter(|end| *end > from_m + SAME_M && *end < to_m - SAME_M).collect();
    // A section's end replaces an even depth close to it.
    let taken = |depth: f64| ends.iter().any(|end| (end - depth).abs() < SAME_M);
    let even = (0..=steps).map(place).filter(|depth| !taken(*depth));
    let mut depths_m: Vec<f64> = even.chain(ends.iter().copied()).collect();
    depths_m.sort_by(f64::total_cmp);
    depths_m.dedup_by(|a, b| (*a - *b).abs() < SAME_M);
    if let Some(last) = depths_m.last_mut() {
        *last = to_m;
    }
    depths_m
}
