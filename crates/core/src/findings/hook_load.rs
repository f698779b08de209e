//! A hook load at or below zero, of a rig that only carries, or below what it pushes with.

use super::{Finding, Kind, Level, window::Window};
use crate::model::Model;

/// A hook load of less than this part of the string's buoyed weight is none: no indicator shows it.
const NONE: f64 = 1e-3;

/// Of a hook load that does not vary.
pub fn steady(model: &Model, hook_load_N: f64) -> Option<Finding> {
    (hook_load_N <= min_N(model)).then(|| finding(model, hook_load_N))
}

/// Of a dynamic run: an error where the mean is so, a warning where it is so at times.
pub fn varying(model: &Model, window: &Window<'_>) -> Option<Finding> {
    let of = window.statistic("hook_load_N")?;
    steady(model, of.mean)
        .or_else(|| (of.min <= min_N(model)).then(|| judged(model, Level::Warning, of.min)))
}

/// What the block still pushes is no reason to stop; where its weight is not known, nothing of it
/// pushes.
fn finding(model: &Model, hook_load_N: f64) -> Finding {
    let block_N = model.rig.block_weight_N.unwrap_or(0.0);
    let level = if hook_load_N + block_N > min_N(model) { Level::Warning } else { Level::Error };
    judged(model, level, hook_load_N)
}

fn judged(model: &Model, level: Level, hook_load_N: f64) -> Finding {
    let limit_N = 0.0 - model.rig.push_N();
    Finding::new(Kind::HookLoadNegative, level).value(hook_load_N).limit(limit_N)
}

/// The least hook load of a string that goes down. A rig that pushes does so up to its force.
fn min_N(model: &Model) -> f64 {
    match model.rig.snubbing_force_N {
        Some(push_N) => -push_N * (1.0 - NONE),
        None => NONE * weight_N(model),
    }
}

/// Buoyed weight of the whole string, N.
pub fn weight_N(model: &Model) -> f64 {
    let density = model.mud.density_kg_per_m3;
    let weights = model.string.components().iter().map(|component| {
        component.buoyed_weight_per_length_N_per_m(density).abs() * component.length_m
    });
    weights.sum()
}
