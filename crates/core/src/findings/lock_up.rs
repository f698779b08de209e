//! A string that slides down and does not bring its weight to the bit.

use super::{Finding, Kind, Level, buckling::Line, hook_load::weight_N, window, window::Window};
use crate::{
    model::Model,
    operation::Operation,
    statics::buckling::{Pushed, push_through, segments, weight_at_bit_N},
};

/// A weight that is short by less than this part of the string's buoyed weight arrives.
const MISSING: f64 = 1e-3;

/// A string that goes down by less than this part of what it is to go stands.
const STANDS: f64 = 0.1;

/// Part of the weight that is requested, less than which does not arrive in a dynamic run.
const ARRIVES: f64 = 0.8;

/// Of a state of equilibrium with this load on the hook. What a helix presses against the wall,
/// which the soft string does not count, is counted here.
pub fn at_rest(
    model: &Model,
    operation: &Operation,
    hook_load_N: f64,
    md_m: &[f64],
    line: &Line<'_>,
) -> Option<Finding> {
    if !operation.slides_down() || hook_load_N > 0.0 && !line.is_helical() {
        return None;
    }
    let segments = segments(model, operation, md_m);
    let push_N = model.rig.push_with_block_N();
    let asked_N = operation.weight_on_bit_now_N();
    let arrives_N = weight_at_bit_N(&segments, push_N, model.buckling);
    if arrives_N >= asked_N - MISSING * weight_N(model) {
        return None;
    }
    let found = Finding::new(Kind::LockUp, Level::Error).value(asked_N).limit(arrives_N);
    Some(match push_through(&segments, asked_N, model.buckling) {
        Pushed::LocksUp(above_bit_m) => found.at(operation.bit_depth_m - above_bit_m),
        Pushed::Through(_) => found,
    })
}

/// Of a dynamic run, whose wall forces are those of the string as it lies: the hook is slack, or
/// the rig pushes with all it has, and the string stands or does not press on the bit.
pub fn of_dynamic(model: &Model, operation: &Operation, window: &Window<'_>) -> Option<Finding> {
    let hook_load_N = window.statistic("hook_load_N")?.mean;
    let slack_N = MISSING * weight_N(model) - model.rig.push_N();
    if !operation.slides_down() || hook_load_N > slack_N {
        return None;
    }
    let asked_N = operation.weight_on_bit_now_N();
    let arrives_N = window.statistic("weight_on_bit_N")?.mean;
    let found = Finding::new(Kind::LockUp, Level::Error).value(asked_N).limit(arrives_N);
    if asked_N > 0.0 {
        return (arrives_N < ARRIVES * asked_N).then_some(found);
    }
    let depth_m = window.series(|of| &of.bit_depth_m);
    let went_m = match depth_m {
        [first, .., last] => last - first,
        _ => 0.0,
    };
    let block = window::mean(window.series(|of| &of.block_velocity_m_per_s));
    let block_travel_m = block * window.length_s();
    (block_travel_m > 0.0 && went_m < STANDS * block_travel_m).then_some(found)
}
